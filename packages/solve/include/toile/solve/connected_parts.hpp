#pragma once

#include <vector>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// [part] the clusters that elements and seams connect, ascending. Each part moves by itself.
std::vector<std::vector<int>> connected_parts(const Problem& problem);

}  // namespace toile::solve
