#include "crossed_planes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

namespace toile::run {

namespace {

/// Plane across one of the directions of space in which a support holds an edge all the time.
struct Plane {
  Eigen::Index axis;
  double place;  ///< mm
};

constexpr double flat = 1e-6;  // mm

std::optional<Plane> plane_of(const solve::Support& support, const std::vector<solve::Vec3>& placed) {
  if (std::count(support.held.begin(), support.held.end(), true) != 1 || !support.axes.empty() || support.turn ||
      support.nodes.size() < 3)
    return std::nullopt;
  const auto axis = std::find(support.held.begin(), support.held.end(), true) - support.held.begin();
  if (support.displacement[axis] != 0.0) return std::nullopt;
  const double place = placed[support.nodes.front()][axis];
  for (const int n : support.nodes)
    if (std::abs(placed[n][axis] - place) > flat) return std::nullopt;
  return Plane{axis, place};
}

/// Nodes of the blocks that the support holds a part of.
std::set<int> fabric_of(const solve::Support& support, const mesh::Mesh& mesh) {
  const std::set<int> held(support.nodes.begin(), support.nodes.end());
  std::set<int> nodes;
  for (const mesh::Block& block : mesh.blocks)
    if (std::any_of(block.connectivity.begin(), block.connectivity.end(), [&](int n) { return held.count(n) > 0; }))
      nodes.insert(block.connectivity.begin(), block.connectivity.end());
  return nodes;
}

}  // namespace

std::string crossed_plane(const solve::Support& support, const mesh::Mesh& mesh,
                          const std::vector<solve::Vec3>& position) {
  constexpr double noticeable = 1e-3;  // of the fabric's extent across the plane
  const auto plane = plane_of(support, mesh.placed);
  if (!plane) return {};
  const std::set<int> nodes = fabric_of(support, mesh);
  double below = 0.0, above = 0.0;
  for (const int n : nodes) {
    below = std::max(below, plane->place - mesh.placed[n][plane->axis]);
    above = std::max(above, mesh.placed[n][plane->axis] - plane->place);
  }
  const double extent = std::max(below, above);
  if (extent <= flat || std::min(below, above) > noticeable * extent) return {};
  const double side = above > below ? 1.0 : -1.0;
  const auto beyond = [&](int n) { return side * (plane->place - position[n][plane->axis]); };
  const int deepest =
      *std::max_element(nodes.begin(), nodes.end(), [&](int a, int b) { return beyond(a) < beyond(b); });
  if (beyond(deepest) <= noticeable * extent) return {};
  const solve::Vec3& x = position[deepest];
  std::ostringstream text;
  text.precision(3);
  text << "fabric has passed through the plane of support \"" << support.name << "\", by " << beyond(deepest)
       << " mm at (" << x[0] << ", " << x[1] << ", " << x[2]
       << ") mm. If that is a plane of symmetry, it has passed through its mirror image, and what is computed near it "
          "does not exist: fabric does not feel fabric";
  return text.str();
}

}  // namespace toile::run
