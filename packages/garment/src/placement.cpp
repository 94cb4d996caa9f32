#include "placement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "vector_input.hpp"

namespace toile::garment {
namespace {

using mesh::Vec2;
using mesh::Vec3;

mesh::Placed lay_flat(const mesh::PanelMesh& flat, const Vec3& origin, const Vec3& x, const Vec3& y) {
  mesh::Placed placed;
  for (const Vec2& node : flat.nodes) placed.position.push_back(origin + node.x() * x + node.y() * y);
  placed.normal.assign(flat.nodes.size(), x.cross(y).normalized());
  return placed;
}

base::Spec flat_spec() {
  return base::Spec("flat", "The flat pattern, moved and turned in space.")
      .reals("origin", "mm", "Position in space of the pattern's origin, or a landmark of the body.",
             base::Reals{0.0, 0.0, 0.0})
      .reals("x direction", "", "Direction in space of the pattern's x axis.", base::Reals{1.0, 0.0, 0.0})
      .reals("y direction", "", "Direction in space of the pattern's y axis, perpendicular to 'x direction'.",
             base::Reals{0.0, 1.0, 0.0});
}

mesh::Placed place_flat(const base::List& placement, const FlatPanel& panel) {
  const Vec3 x = read_direction(placement, "x direction");
  const Vec3 y = read_direction(placement, "y direction");
  if (std::abs(x.dot(y)) > 1e-6) placement.fail("y direction", "must be perpendicular to \"x direction\"");
  return lay_flat(panel.mesh, read_vector(placement, "origin"), x, y);
}

}  // namespace

Vec3 read_vector(const base::List& list, const std::string& name) {
  const base::Reals& values = list.reals(name);
  if (values.size() != 3) {
    list.fail(name, "has " + std::to_string(values.size()) + " numbers; a vector in space needs three");
  }
  return {values[0], values[1], values[2]};
}

Vec3 read_direction(const base::List& list, const std::string& name) {
  const Vec3 direction = read_vector(list, name);
  if (direction.norm() <= 0.0) list.fail(name, "must not be zero");
  return direction.normalized();
}

Vec3 read_perpendicular(const base::List& list, const std::string& name, const Vec3& axis) {
  const Vec3 wanted = read_direction(list, name);
  const Vec3 part = wanted - wanted.dot(axis) * axis;
  if (part.norm() <= 1e-6) list.fail(name, "must not be parallel to the axis");
  return part.normalized();
}

const std::vector<Placement>& placements() {
  static const std::vector<Placement> all{{flat_spec(), place_flat, nullptr},
                                          wrap_placement(),
                                          free_wrap_placement(),
                                          sphere_placement(),
                                          guide_placement(),
                                          pattern_placement()};
  return all;
}

base::Spec placement_spec() {
  base::Spec spec("Placement",
                  "Where the panel starts in space. It starts bent but, on a developable surface and at "
                  "its natural width, unstretched.");
  std::vector<base::Spec> variants;
  for (const Placement& placement : placements()) variants.push_back(placement.spec);
  spec.variant("type", "Kind of placement.", variants, std::string("flat"));
  return spec;
}

const Placement& placement_of(const base::List& list) {
  const std::string& type = list.word("type");
  const auto& all = placements();
  return *std::find_if(all.begin(), all.end(), [&type](const Placement& p) { return p.spec.name() == type; });
}

mesh::Placed place_panel(const base::List& list, const FlatPanel& panel) {
  if (!list.has_list("Placement")) return lay_flat(panel.mesh, Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY());
  const base::List placement = list.list("Placement");
  return placement_of(placement).place(placement, panel);
}

}  // namespace toile::garment
