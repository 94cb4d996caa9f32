#pragma once

#include <map>
#include <string>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// Every value of a list that was validated against `spec`, defaults included, as text by its path ("scene > Panels >
/// front > width"): equal texts are equal values, bit for bit.
std::map<std::string, std::string> values_of(const List& list, const Spec& spec);

}  // namespace toile::base
