#pragma once

#include <string>
#include <vector>

#include "toile/material/material.hpp"

namespace toile::material {

/// The words of a parameter's `choices`; empty for a number.
std::vector<std::string> words_of(const ParamInfo& info);
/// The words are "false" and "true".
bool is_flag(const std::vector<std::string>& words);

}  // namespace toile::material
