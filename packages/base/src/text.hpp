#pragma once

#include <string>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b` (optimal string
/// alignment distance; Damerau 1964), blind to upper and lower case.
int edit_distance(const std::string& a, const std::string& b);

/// Without the blanks and line ends around it.
std::string trimmed(const std::string& text);

std::string join(const Texts& words, const std::string& separator);

/// Shortest decimal text that reads back as the same number.
std::string number_text(double value);

/// A value as messages and the input reference show it: 1.5, "word", {1, 2}.
std::string value_text(const Value& value);

/// A type as the XML file names it, e.g. "Array(double)".
std::string type_text(Type type);

}  // namespace toile::base
