#pragma once

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/parse_tree.hpp>

// Grammar of a formula: definitions "name = sum;", then one sum. From loose to tight: + -, * /, sign, ^ (from the right).
namespace toile::material::formula::grammar {

using namespace tao::pegtl;

struct blank : star<space> {};
template <class Rule>
struct token : seq<Rule, blank> {};

struct fraction : seq<one<'.'>, star<digit>> {};
struct exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, plus<digit>> {};
struct number : seq<sor<seq<plus<digit>, opt<fraction>>, seq<one<'.'>, plus<digit>>>, opt<exponent>> {};
struct name : identifier {};
struct function_name : identifier {};
struct defined_name : identifier {};
struct plus_or_minus : one<'+', '-'> {};
struct times_or_over : one<'*', '/'> {};
struct less_or_greater : one<'<', '>'> {};

struct operand;
struct closing : one<')'> {};
struct semicolon : one<';'> {};
struct end : eof {};

struct product : seq<must<operand>, star<token<times_or_over>, must<operand>>> {};
struct sum : seq<product, star<token<plus_or_minus>, product>> {};
struct argument : seq<sum, opt<token<less_or_greater>, sum>> {};
struct call : seq<token<function_name>, token<one<'('>>, argument, star<token<one<','>>, argument>, token<must<closing>>> {};
struct parentheses : seq<token<one<'('>>, sum, token<must<closing>>> {};
struct base : sor<token<number>, call, token<name>, parentheses> {};
struct power : seq<base, opt<token<one<'^'>>, must<operand>>> {};
struct negative : seq<token<one<'-'>>, must<operand>> {};
struct positive : seq<token<one<'+'>>, must<operand>> {};
struct operand : sor<negative, positive, power> {};
struct definition
    : seq<at<identifier, blank, one<'='>>, token<defined_name>, token<one<'='>>, sum, token<must<semicolon>>> {};
struct formula : seq<blank, star<definition>, sum, opt<token<one<';'>>>, must<end>> {};

/// What is said where a rule that must match does not.
template <class Rule>
inline constexpr const char* message = nullptr;
template <>
inline constexpr const char* message<operand> = "expected a number, a name, a function or \"(\"";
template <>
inline constexpr const char* message<closing> = "expected an operator or \")\"";
template <>
inline constexpr const char* message<semicolon> = "expected an operator or \";\" at the end of the definition";
template <>
inline constexpr const char* message<end> = "expected an operator or the end of the formula";

struct Messages {
  template <class Rule>
  static constexpr const char* message = grammar::message<Rule>;
};
template <class Rule>
using Control = must_if<Messages>::control<Rule>;

/// Rules that become nodes of the tree.
template <class Rule>
using Selector =
    parse_tree::selector<Rule, parse_tree::store_content::on<number, name, function_name, defined_name, plus_or_minus,
                                                             times_or_over, less_or_greater>,
                         parse_tree::remove_content::on<call, negative, definition, formula>,
                         parse_tree::fold_one::on<product, sum, argument, power>>;

}  // namespace toile::material::formula::grammar
