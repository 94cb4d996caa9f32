#pragma once

#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/parse_tree.hpp>

// Grammar of a formula: definitions "name = sum;", then one sum. From loose to tight: + -, * /, sign, ^ (from the
// right).
namespace toile::material::formula::grammar {

using namespace tao::pegtl;

struct Blank : star<space> {};
template <class Rule>
struct Token : seq<Rule, Blank> {};

struct Fraction : seq<one<'.'>, star<digit>> {};
struct Exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, plus<digit>> {};
struct Number : seq<sor<seq<plus<digit>, opt<Fraction>>, seq<one<'.'>, plus<digit>>>, opt<Exponent>> {};
struct Name : identifier {};
struct FunctionName : identifier {};
struct DefinedName : identifier {};
struct PlusOrMinus : one<'+', '-'> {};
struct TimesOrOver : one<'*', '/'> {};
struct LessOrGreater : one<'<', '>'> {};

struct Operand;
struct Closing : one<')'> {};
struct Semicolon : one<';'> {};
struct End : eof {};

struct Product : seq<must<Operand>, star<Token<TimesOrOver>, must<Operand>>> {};
struct Sum : seq<Product, star<Token<PlusOrMinus>, Product>> {};
struct Argument : seq<Sum, opt<Token<LessOrGreater>, Sum>> {};
struct Call
    : seq<Token<FunctionName>, Token<one<'('>>, Argument, star<Token<one<','>>, Argument>, Token<must<Closing>>> {};
struct Parentheses : seq<Token<one<'('>>, Sum, Token<must<Closing>>> {};
struct Atom : sor<Token<Number>, Call, Token<Name>, Parentheses> {};
struct Power : seq<Atom, opt<Token<one<'^'>>, must<Operand>>> {};
struct Negative : seq<Token<one<'-'>>, must<Operand>> {};
struct Positive : seq<Token<one<'+'>>, must<Operand>> {};
struct Operand : sor<Negative, Positive, Power> {};
struct Definition
    : seq<at<identifier, Blank, one<'='>>, Token<DefinedName>, Token<one<'='>>, Sum, Token<must<Semicolon>>> {};
struct Formula : seq<Blank, star<Definition>, Sum, opt<Token<one<';'>>>, must<End>> {};

/// What is said where a rule that must match does not.
template <class Rule>
inline constexpr const char* message = nullptr;
template <>
inline constexpr const char* message<Operand> = "expected a number, a name, a function or \"(\"";
template <>
inline constexpr const char* message<Closing> = "expected an operator or \")\"";
template <>
inline constexpr const char* message<Semicolon> = "expected an operator or \";\" at the end of the definition";
template <>
inline constexpr const char* message<End> = "expected an operator or the end of the formula";

struct Messages {
  template <class Rule>
  static constexpr const char* message = grammar::message<Rule>;
};
template <class Rule>
using Control = must_if<Messages>::control<Rule>;

/// Rules that become nodes of the tree.
template <class Rule>
using Selector = parse_tree::selector<
    Rule,
    parse_tree::store_content::on<Number, Name, FunctionName, DefinedName, PlusOrMinus, TimesOrOver, LessOrGreater>,
    parse_tree::remove_content::on<Call, Negative, Definition, Formula>,
    parse_tree::fold_one::on<Product, Sum, Argument, Power>>;

}  // namespace toile::material::formula::grammar
