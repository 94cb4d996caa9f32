#pragma once

#include <tao/pegtl.hpp>

// Grammar of the data of an SVG path, of a transform and of lists of numbers.
namespace toile::pattern::svg {

using namespace tao::pegtl;

struct Blank : star<space> {};
struct Gap : seq<Blank, opt<one<','>>, Blank> {};
struct Exponent : seq<one<'e', 'E'>, opt<one<'+', '-'>>, plus<digit>> {};
struct Number : seq<opt<one<'+', '-'>>, sor<seq<plus<digit>, opt<one<'.'>, star<digit>>>, seq<one<'.'>, plus<digit>>>,
                    opt<Exponent>> {};
struct Flag : one<'0', '1'> {};
struct Pair : seq<Number, Gap, Number> {};
struct TwoPairs : seq<Pair, Gap, Pair> {};
struct ThreePairs : seq<TwoPairs, Gap, Pair> {};
struct ArcNumbers : seq<Number, Gap, Number, Gap, Number, Gap, Flag, Gap, Flag, Gap, Pair> {};

/// One set of arguments of the command whose letter came last.
template <class Arguments>
struct Step : seq<Arguments> {};
struct Close : one<'Z', 'z'> {};
template <class Arguments, char... letters>
struct Letter : one<letters...> {};
template <class Arguments, char... letters>
struct Command : if_must<Letter<Arguments, letters...>, Blank, Step<Arguments>, star<Gap, Step<Arguments>>> {};
struct Commands
    : sor<Command<Pair, 'L', 'l', 'T', 't', 'M', 'm'>, Command<Number, 'H', 'h', 'V', 'v'>,
          Command<ThreePairs, 'C', 'c'>, Command<TwoPairs, 'S', 's', 'Q', 'q'>, Command<ArcNumbers, 'A', 'a'>, Close> {
};
struct Path : seq<Blank, must<at<one<'M', 'm'>>>, plus<Commands, Blank>, must<eof>> {};

struct Name : plus<alpha> {};
struct Function : seq<Name, Blank, one<'('>, Blank, Number, star<Gap, Number>, Blank, one<')'>> {};
struct Transform : seq<Blank, star<Function, Gap>, must<eof>> {};

struct Numbers : seq<Blank, star<Number, Gap>, must<eof>> {};

}  // namespace toile::pattern::svg
