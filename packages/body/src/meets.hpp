#pragma once

#include <limits>

#include "toile/body/body.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// Whether the box round some vertices meets the region, widened by `margin`.
template <class Corners>
bool meets(const TriangleMesh& mesh, const Corners& corners, const Region& region, double margin) {
  const double infinite = std::numeric_limits<double>::infinity();
  Vec3 lower = Vec3::Constant(infinite), upper = -lower;
  double bottom = infinite, top = -infinite;
  for (const int corner : corners) {
    const Vec3& vertex = mesh.vertices[corner];
    lower = lower.cwiseMin(vertex);
    upper = upper.cwiseMax(vertex);
    bottom = std::min(bottom, vertex.dot(region.direction));
    top = std::max(top, vertex.dot(region.direction));
  }
  return (lower.array() <= region.upper.array() + margin).all() &&
         (upper.array() >= region.lower.array() - margin).all() && bottom <= region.top + margin &&
         top >= region.bottom - margin;
}

}  // namespace toile::body
