#include "toile/mesh/quality.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::mesh {
namespace {

void add_element(const std::vector<Vec2>& pattern, const int* nodes, int sides, Quality& quality) {
  const auto at = [&](int k) -> const Vec2& { return pattern[static_cast<std::size_t>(nodes[k % sides])]; };
  double least = std::numeric_limits<double>::infinity(), most = -least, shortest = least, longest = 0.0;
  double smallest_angle = 360.0;
  Vec2 centre = Vec2::Zero();
  for (int k = 0; k < sides; ++k) {
    const Vec2 next = at(k + 1) - at(k), last = at(k + sides - 1) - at(k);
    const double cross = next.x() * last.y() - next.y() * last.x();
    const double angle = std::atan2(cross, next.dot(last)) * 180.0 / M_PI;
    smallest_angle = std::min(smallest_angle, angle);
    quality.largest_angle = std::max(quality.largest_angle, angle);
    least = std::min(least, cross);
    most = std::max(most, cross);
    shortest = std::min(shortest, next.norm());
    longest = std::max(longest, next.norm());
    centre += at(k) / sides;
  }
  if (smallest_angle < quality.smallest_angle) {
    quality.smallest_angle = smallest_angle;
    quality.worst = centre;
  }
  quality.smallest_jacobian = std::min(quality.smallest_jacobian, least / most);
  quality.largest_aspect = std::max(quality.largest_aspect, longest / shortest);
}

void add_elements(const std::vector<Vec2>& pattern, const std::vector<int>& connectivity, int sides, Quality& quality) {
  for (std::size_t k = 0; k < connectivity.size(); k += static_cast<std::size_t>(sides))
    add_element(pattern, &connectivity[k], sides, quality);
}

}  // namespace

Quality quality_of(const PanelMesh& panel) {
  Quality quality;
  for (const PanelPart& part : panel.parts)
    add_elements(panel.nodes, part.connectivity, part.nodes_per_element, quality);
  return quality;
}

Quality quality_of(const Mesh& mesh, int panel) {
  Quality quality;
  for (const Block& block : mesh.blocks)
    if (block.panel == panel) add_elements(mesh.pattern, block.connectivity, block.nodes_per_element, quality);
  return quality;
}

}  // namespace toile::mesh
