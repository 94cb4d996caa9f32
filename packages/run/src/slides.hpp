#pragma once

#include <string>
#include <vector>

#include "toile/solve/problem.hpp"

namespace toile::run {

/// What is to be said of the parts of a garment (solve::connected_parts) that have left their place as a whole: a line
/// each. `position`: [node] mm. Nothing where supports move the garment, or without a body.
std::vector<std::string> parts_that_slid(const solve::Problem& problem, const std::vector<solve::Vec3>& position);

}  // namespace toile::run
