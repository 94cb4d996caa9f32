#include <Eigen/Geometry>
#include <cmath>

#include "placement.hpp"
#include "vector_input.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;

mesh::Placed place_as_drawn(const base::List& list, const FlatPanel& panel) {
  if (!panel.drawn)
    list.fail("type",
              "no file of patterns says where this panel lies: that takes \"shape\" = pattern file and a file that "
              "places its panels (JSON does); else lay the panel \"flat\" or round the body by \"wrap\"");
  const Vec3 up = read_direction(list, "up"), front = read_direction(list, "front");
  if (std::abs(up.dot(front)) > 1e-6) list.fail("front", "must be perpendicular to \"up\"");
  Eigen::Matrix3d turn;
  turn << up.cross(front), up, front;
  const Eigen::Matrix3d axes = turn * panel.drawn->rotation;
  const Vec3 origin = read_vector(list, "origin") + turn * panel.drawn->translation;
  mesh::Placed placed;
  for (const mesh::Vec2& node : panel.mesh.nodes)
    placed.position.push_back(origin + node.x() * axes.col(0) + node.y() * axes.col(1));
  placed.normal.assign(panel.mesh.nodes.size(), axes.col(2));
  return placed;
}

}  // namespace

base::Spec pattern_placement_spec(const std::string& name, const std::string& text) {
  return base::Spec(name, text)
      .reals("origin", "mm", "Position in space of the origin of the file, or a landmark of the body.",
             base::Reals{0.0, 0.0, 0.0})
      .reals("up", "", "Direction in space of the file's y axis, which points up.", base::Reals{0.0, 0.0, 1.0})
      .reals("front", "",
             "Direction in space of the file's z axis, which points to the front of the wearer; perpendicular to 'up'.",
             base::Reals{0.0, -1.0, 0.0});
}

Placement pattern_placement() {
  return {pattern_placement_spec("from pattern",
                                 "Flat, where the file of patterns has the panel; the garment moves as a whole."),
          place_as_drawn, nullptr};
}

}  // namespace toile::garment
