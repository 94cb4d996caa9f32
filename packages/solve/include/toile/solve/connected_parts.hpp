#pragma once

#include <string>
#include <vector>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// [part] the clusters that elements and seams connect, ascending. Each part moves by itself.
std::vector<std::vector<int>> connected_parts(const Problem& problem);

/// How a part is called in messages, by the panels that its clusters belong to: panel "front", or the part of panels
/// "front", "back".
std::string panels_of(const Problem& problem, const std::vector<int>& clusters);

}  // namespace toile::solve
