#pragma once

#include <string>
#include <vector>

#include "layout.hpp"

namespace toile::solve {

/// A rigid motion of the whole garment that neither a support, nor a seam, nor the body resists.
struct NullMotion {
  std::string name;  ///< e.g. "rotation about the axis (0, 0, 1) through (0, 0, 0)"
  int cluster;       ///< where one component is pinned against it
  int component;     ///< 0..2
};

/// The null motions of a configuration: rigid motions r for which the held components, the separations across seams
/// (`seams_closed`: none) and, at nodes that touch the body, the gap do not change to first order.
std::vector<NullMotion> find_null_motions(const Problem& problem, const State& state,
                                          const Held& held, bool seams_closed);

}  // namespace toile::solve
