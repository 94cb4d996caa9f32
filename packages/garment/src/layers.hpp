#pragma once

#include <vector>

#include "toile/base/parameters.hpp"

namespace toile::garment {

/// [panel] The panels that lie between it and the body, by their place in the list, ascending: those that "over" names,
/// and what is beneath these. Empty altogether if no panel names any. Throws InputError for a name that is none, and
/// for panels that lie over each other.
std::vector<std::vector<int>> read_layers(const std::vector<base::List>& panels);

}  // namespace toile::garment
