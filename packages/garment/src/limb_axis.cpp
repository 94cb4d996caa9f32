#include "limb_axis.hpp"

#include <algorithm>
#include <vector>

#include "toile/base/error.hpp"
#include "toile/garment/bent_axis.hpp"
#include "vector_input.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;

std::vector<Vec3> read_points(const base::List& list) {
  const base::Reals& values = list.reals("axis");
  if (values.size() < 6 || values.size() % 3 != 0)
    list.fail("axis", "has " + std::to_string(values.size()) +
                          " numbers; allowed are points x, y, z, x, y, z, ..., at least two of them");
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < values.size(); k += 3) {
    points.emplace_back(values[k], values[k + 1], values[k + 2]);
    if (k > 0 && points[k / 3] == points[k / 3 - 1])
      list.fail("axis", "repeats its point number " + std::to_string(k / 3) +
                            "; each point must differ from the one before it");
  }
  return points;
}

double shortest_segment(const std::vector<Vec3>& points) {
  double shortest = (points[1] - points[0]).norm();
  for (std::size_t k = 2; k < points.size(); ++k) shortest = std::min(shortest, (points[k] - points[k - 1]).norm());
  return shortest;
}

Axis read_straight(const base::List& list) {
  for (const char* end : {"axis bottom", "axis top"})
    if (!list.given(end))
      list.fail(end,
                "is missing: a straight axis needs \"axis bottom\" and \"axis top\"; that of a bent limb is given "
                "by its points in \"axis\"");
  if (list.given("smoothing")) list.fail("smoothing", "rounds the corners of \"axis\", which is not given");
  const Vec3 bottom = read_vector(list, "axis bottom");
  const Vec3 along = read_vector(list, "axis top") - bottom;
  if (along.norm() <= 0.0) list.fail("axis top", "must differ from \"axis bottom\"");
  const Vec3 direction = along.normalized();
  return {bottom, direction, read_perpendicular(list, "zero direction", direction)};
}

}  // namespace

mesh::BentAxis read_bent_axis(const base::List& list) {
  const std::vector<Vec3> points = read_points(list);
  const double smoothing = list.real("smoothing");
  try {
    return mesh::BentAxis(points, smoothing > 0.0 ? smoothing : shortest_segment(points));
  } catch (const base::InputError& error) {
    list.fail("axis", error.what());
  }
}

LimbAxis::LimbAxis(const base::List& placement) {
  if (!placement.given("axis")) {
    straight_ = read_straight(placement);
    return;
  }
  for (const char* other : {"axis bottom", "axis top"})
    if (placement.given(other)) placement.fail(other, "goes with a straight axis; give it or \"axis\", not both");
  bent_ = read_bent_axis(placement);
  const mesh::BentAxis::Place start = bent_->at(0.0);
  straight_ = {start.point, start.direction, read_perpendicular(placement, "zero direction", start.direction),
               "the first point of \"axis\", along it,"};
}

Axis LimbAxis::frame(double height) const {
  if (!bent_) return straight_;
  const mesh::BentAxis::Place there = bent_->at(height);
  return {there.point - height * there.direction, there.direction, there.turn * straight_.zero, straight_.start};
}

body::Vec3 LimbAxis::curvature(double height) const {
  return bent_ ? bent_->at(height).curvature : body::Vec3(Vec3::Zero());
}

base::Spec& add_axis_parameters(base::Spec& spec) {
  return spec
      .reals("axis bottom", "mm",
             "Lower point of a straight axis, or a landmark of the body: heights count from here towards 'axis top'.",
             base::Reals{})
      .reals("axis top", "mm", "A second point on the straight axis, above the first, or a landmark.", base::Reals{})
      .reals("axis", "mm",
             "Instead of both, the axis of a bent limb (knee, elbow): points x, y, z, x, y, z, ... or landmarks from "
             "the lower end "
             "to the upper one. Its corners are rounded, and heights count along it from the first point; it goes on "
             "straight beyond both ends. It must run inside the limb.",
             base::Reals{})
      .real("smoothing", "mm",
            "Of 'axis': length over which each corner is spread to either side. The larger, the further apart the "
            "sections lie at the inner side of a bend, and the more the axis cuts the corner; 0: the shortest distance "
            "of two neighbouring points.",
            0.0, base::Range::non_negative())
      .reals("zero direction", "",
             "Direction in space, seen from the axis, from which 'angle' counts; along a bent axis it is carried on "
             "from height 0 without a twist.",
             base::Reals{1.0, 0.0, 0.0});
}

}  // namespace toile::garment
