#pragma once

#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/solve/problem.hpp"

namespace toile::solve {

/// [node] axes of a support of "hold" = "along the limb": along the limb in the tangent plane of the body, round it,
/// and the body's normal. Nodes that a seam ties have the same. Throws base::InputError where there is no such
/// direction.
std::vector<Frame> limb_directions(const base::List& entry, const Problem& problem, const std::vector<int>& nodes);

}  // namespace toile::solve
