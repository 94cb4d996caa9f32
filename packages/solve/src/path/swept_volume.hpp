#pragma once

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// Volume that the panels under pressure have swept along their normals since they were placed, mm^3: of a closed part,
/// or one that ends in planes that hold its edges, the change of what it encloses.
double swept_volume(const Problem& problem, const State& state);

}  // namespace toile::solve
