#pragma once

#include <cmath>
#include <cstddef>

#include "shell_point.hpp"

namespace toile::element {

/// Geometry of one shell element.
template <int Nodes, int Points, int ShearPoints>
struct ShellState {
  ShellNodes<Nodes> nodes;
  ShellPoint<Nodes> point[Points];                 ///< of membrane and bending
  ReferencePoint<Nodes> shear_point[ShearPoints];  ///< of transverse shear, areas and stabilisation
  bool folded;                                     ///< pattern or reference, at one of the points

  void set_reference(const Batch& batch, std::ptrdiff_t e, const Rule<Nodes, Points>& rule,
                     const Rule<Nodes, ShearPoints>& shear_rule);
};

template <int Nodes, int Points, int ShearPoints>
void ShellState<Nodes, Points, ShearPoints>::set_reference(const Batch& batch, std::ptrdiff_t e,
                                                           const Rule<Nodes, Points>& rule,
                                                           const Rule<Nodes, ShearPoints>& shear_rule) {
  const double cosine = std::cos(batch.wale_angle[e]), sine = std::sin(batch.wale_angle[e]);
  nodes.set_reference(batch, e);
  folded = false;
  for (int p = 0; p < ShearPoints; ++p) {
    shear_point[p].set(nodes, shear_rule.dN[p], shear_rule.weight[p], cosine, sine);
    folded = folded || !(shear_point[p].area > 0.0);
  }
  for (int p = 0; p < Points; ++p) {
    if constexpr (Points == ShearPoints) {  // full integration: the same points
      point[p].reference = shear_point[p];
    } else {
      point[p].reference.set(nodes, rule.dN[p], rule.weight[p], cosine, sine);
      folded = folded || !(point[p].reference.area > 0.0);
    }
    point[p].set_curvature(nodes);
  }
}

}  // namespace toile::element
