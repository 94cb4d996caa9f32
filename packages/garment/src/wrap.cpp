#include <cmath>
#include <functional>
#include <sstream>
#include <utility>

#include "body_end.hpp"
#include "placement.hpp"
#include "section.hpp"
#include "toile/base/error.hpp"
#include "vector_input.hpp"

namespace toile::garment {
namespace {

using mesh::Vec3;

base::Spec add_wrap_parameters(base::Spec spec) {
  return spec.reals("axis bottom", "mm", "Lower point of the axis: heights count from here towards 'axis top'.")
      .reals("axis top", "mm", "A second point on the axis, above the first.")
      .real("from", "mm", "Height along the axis of the panel's bottom.")
      .real("to", "mm", "Height along the axis of the panel's top.")
      .reals("zero direction", "", "Direction in space, seen from the axis, from which 'angle' counts.",
             base::Reals{1.0, 0.0, 0.0})
      .real("angle", "deg",
            "Where the panel's centre line lies: its part of the girth, 360 being once round, counter-clockwise seen "
            "from the top of the axis. Two panels of coverage 1/2 at 0 and 180 meet on any section.",
            0.0)
      .real("coverage", "",
            "Part of the girth that the panel covers at every level, so that the hoop stretch is uniform there; 0: the "
            "width of the pattern itself (unstretched).",
            0.0, base::Range::between(0.0, 1.0));
}

Axis read_axis(const base::List& list) {
  const Vec3 bottom = read_vector(list, "axis bottom");
  const Vec3 along = read_vector(list, "axis top") - bottom;
  if (along.norm() <= 0.0) list.fail("axis top", "must differ from \"axis bottom\"");
  const Vec3 direction = along.normalized();
  return {bottom, direction, read_perpendicular(list, "zero direction", direction)};
}

/// Heights of the panel's bottom and top along the axis.
std::pair<double, double> read_heights(const base::List& list) {
  if (list.real("to") <= list.real("from")) list.fail("to", "must be above \"from\"");
  return {list.real("from"), list.real("to")};
}

/// Height of each row of the grid: linear in the mean pattern coordinate y of the row.
std::vector<double> row_heights(const base::List& list, const mesh::Grid& grid) {
  const auto [from, to] = read_heights(list);
  std::vector<double> level;
  for (int j = 0; j <= grid.along; ++j) {
    double sum = 0.0;
    for (const int id : grid.row(j)) sum += grid.nodes[id].y();
    level.push_back(sum / (grid.across + 1));
    if (j > 0 && level[j] <= level[j - 1]) list.fail("type", "the rows of the pattern must rise along its y axis");
  }
  std::vector<double> heights;
  for (const double y : level) heights.push_back(from + (to - from) * (y - level[0]) / (level.back() - level[0]));
  return heights;
}

/// Arc length of the pattern from the left end of row j to each of its nodes, mm.
std::vector<double> row_arc(const mesh::Grid& grid, int j) {
  std::vector<double> arc{0.0};
  for (int i = 1; i <= grid.across; ++i) {
    arc.push_back(arc.back() + (grid.nodes[grid.node(i, j)] - grid.nodes[grid.node(i - 1, j)]).norm());
  }
  return arc;
}

using SectionAt = std::function<Section(const Axis&, double height)>;
/// Outward unit normal of the surface at a place on its section, given by its angle and its position.
using NormalAt = std::function<Vec3(const Axis&, double angle, const Vec3& position)>;

/// Puts every row of the grid on the section at its height.
mesh::Placed wrap(const base::List& list, const mesh::Grid& grid, const SectionAt& section_at,
                  const NormalAt& normal_at) {
  const Axis axis = read_axis(list);
  const std::vector<double> heights = row_heights(list, grid);
  const double coverage = list.real("coverage");
  mesh::Placed placed;
  for (int j = 0; j <= grid.along; ++j) {
    const Section section = section_at(axis, heights[j]);
    const std::vector<double> arc = row_arc(grid, j);
    const double width = coverage > 0.0 ? coverage * section.girth() : arc.back();
    if (width > section.girth() * (1.0 + 1e-9)) {
      std::ostringstream text;
      text << "the pattern is " << width << " mm wide at the height " << heights[j] << " mm, but the girth there is "
           << section.girth() << " mm: give a \"coverage\" of at most 1, or wrap the panel further away from the axis";
      list.fail("coverage", text.str());
    }
    const double centre = list.real("angle") / 360.0 * section.girth();
    for (const double s : arc) {
      const double angle = section.angle_at(centre + width * (s / arc.back() - 0.5));
      placed.position.push_back(axis.at(heights[j]) + section.radius(angle) * axis.ray(angle));
      placed.normal.push_back(normal_at(axis, angle, placed.position.back()));
    }
  }
  return placed;
}

mesh::Placed place_on_body(const base::List& list, const mesh::Grid& grid, const body::Surface* body) {
  if (body == nullptr) list.fail("type", "\"wrap\" needs a body, and the scene has none; \"free wrap\" does not");
  const double offset = list.real("offset");
  const auto section_at = [&list, body, offset](const Axis& axis, double height) {
    try {
      return trace_section(*body, axis, height, offset);
    } catch (const base::InputError& error) {
      refuse_section(list, *body, axis, height, "axis bottom", error.what());
    }
  };
  // The panel lies where the gap is the offset, so the gap's gradient is its normal.
  const auto normal_at = [&list, body](const Axis&, double, const Vec3& position) {
    const body::SurfacePoint point = body->closest(position);
    if (!point.found) list.fail("offset", "the body's surface is out of reach from there, so the panel has no normal");
    return point.normal;
  };
  return wrap(list, grid, section_at, normal_at);
}

mesh::Placed place_freely(const base::List& list, const mesh::Grid& grid, const body::Surface*) {
  const base::Reals& around = list.reals("around");
  if (around.size() != 2) list.fail("around", "needs two radii, one at \"from\" and one at \"to\"");
  const double from = list.real("from");
  const double to = list.real("to");
  const double taper = (around[1] - around[0]) / (to - from);
  const auto section_at = [&around, from, taper](const Axis&, double height) {
    constexpr int samples = 16;  // any number: a circle is represented exactly
    return Section(std::vector<double>(samples, around[0] + taper * (height - from)));
  };
  const auto normal_at = [taper](const Axis& axis, double angle, const Vec3&) {
    return Vec3((axis.ray(angle) - taper * axis.direction).normalized());
  };
  return wrap(list, grid, section_at, normal_at);
}

body::Region reach_of_wrap(const base::List& list) {
  const Axis axis = read_axis(list);
  const auto [from, to] = read_heights(list);
  body::Region region;
  region.direction = axis.direction;
  region.bottom = axis.at(from).dot(axis.direction);
  region.top = axis.at(to).dot(axis.direction);
  region.seed = axis.at(0.5 * (from + to));
  return region;
}

}  // namespace

Placement wrap_placement() {
  base::Spec spec = add_wrap_parameters(base::Spec("wrap", "Round the body, level by level."));
  spec.real("offset", "mm", "Distance from the body's surface.", 0.0, base::Range::non_negative());
  return {spec, place_on_body, reach_of_wrap};
}

Placement free_wrap_placement() {
  base::Spec spec = add_wrap_parameters(
      base::Spec("free wrap",
                 "Round a cylinder or cone, without a body. Without a coverage, with two equal radii and with heights "
                 "as far apart as the panel is high, a rectangle is rolled without any strain."));
  spec.reals("around", "mm", "Radius at 'from' and at 'to'.", base::required, base::Range::positive());
  return {spec, place_freely, reach_of_wrap};
}

}  // namespace toile::garment
