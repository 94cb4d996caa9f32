#pragma once

#include <string>
#include <vector>

#include "equilibrium/layout.hpp"

namespace toile::solve {

/// A rigid motion of a connected part of the garment that neither a support, nor a seam, nor the body resists.
struct NullMotion {
  std::string name;  ///< e.g. "rotation about the axis (0, 0, 1) through (0, 0, 0)"
  int cluster;       ///< where one component is pinned; all pins of a part together hold all its motions
  int component;     ///< 0..2
};

/// Clusters that lie within 1 mm of the body: where it will guide a garment whose contact is not known yet.
std::vector<bool> near_body(const Problem& problem, const State& state);
/// Clusters that the body presses.
std::vector<bool> in_contact(const State& state);

/// The null motions of a configuration: rigid motions r for which the held components, the separations across seams
/// (`seams_closed`: none) and, at the clusters that the body guides, the gap do not change to first order.
std::vector<NullMotion> find_null_motions(const Problem& problem, const State& state, const Held& held,
                                          bool seams_closed, const std::vector<bool>& guided);

}  // namespace toile::solve
