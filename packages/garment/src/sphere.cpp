#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "placement.hpp"
#include "section.hpp"
#include "vector_input.hpp"

namespace toile::garment {
namespace {

using mesh::Vec2;
using mesh::Vec3;

base::Spec sphere_spec() {
  return base::Spec("sphere",
                    "Onto a sphere: the pattern's x becomes arc length along the equator, its y arc length from the "
                    "equator towards the pole. Away from the equator this shortens the pattern's x; a shell that is to "
                    "start without strain takes the placed shape as its stress-free one (list Shell).")
      .real("radius", "mm", "Radius of the sphere.", base::required, base::Range::positive())
      .reals("centre", "mm", "Centre of the sphere.", base::Reals{0.0, 0.0, 0.0})
      .reals("polar axis", "", "Direction from the centre to the pole.", base::Reals{0.0, 0.0, 1.0})
      .reals("zero direction", "", "Direction in space, seen from the centre, of the meridian of the pattern's x = 0.",
             base::Reals{1.0, 0.0, 0.0});
}

/// Refuses patterns that reach a pole, where rows would shrink to a point, or overlap themselves round the axis.
void check_extent(const base::List& list, const mesh::PanelMesh& flat, double radius) {
  const auto by_x = [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); };
  const auto by_y = [](const Vec2& a, const Vec2& b) { return std::abs(a.y()) < std::abs(b.y()); };
  const auto [west, east] = std::minmax_element(flat.nodes.begin(), flat.nodes.end(), by_x);
  const double span = (east->x() - west->x()) / radius * 180.0 / M_PI;
  const double latitude = std::abs(std::max_element(flat.nodes.begin(), flat.nodes.end(), by_y)->y()) / radius;
  std::ostringstream text;
  if (latitude > M_PI / 2.0 - 1e-6) {
    text << "the pattern reaches the latitude " << latitude * 180.0 / M_PI
         << " degrees; it must end before the pole at 90 degrees";
  } else if (span > 360.0 * (1.0 + 1e-9)) {
    text << "the pattern is " << span << " degrees long round the equator; it must not overlap itself";
  }
  if (!text.str().empty()) list.fail("radius", text.str());
}

mesh::Placed place_on_sphere(const base::List& list, const FlatPanel& panel) {
  const mesh::PanelMesh& flat = panel.mesh;
  const double radius = list.real("radius");
  check_extent(list, flat, radius);
  const Vec3 pole = read_direction(list, "polar axis");
  const Axis axis{read_vector(list, "centre"), pole, read_perpendicular(list, "zero direction", pole)};
  mesh::Placed placed;
  for (const Vec2& node : flat.nodes) {
    const double latitude = node.y() / radius;
    placed.normal.push_back(std::cos(latitude) * axis.ray(node.x() / radius) + std::sin(latitude) * pole);
    placed.position.push_back(axis.at(0.0) + radius * placed.normal.back());
  }
  return placed;
}

}  // namespace

Placement sphere_placement() {
  return {sphere_spec(), place_on_sphere, nullptr};
}

}  // namespace toile::garment
