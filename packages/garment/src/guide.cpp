// Onto any body along a line on it.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "placement.hpp"
#include "toile/base/error.hpp"
#include "vector_input.hpp"

namespace toile::garment {
namespace {

using mesh::Vec2;
using mesh::Vec3;

constexpr double step = 1.0;  // mm: a body's radii are much larger

base::Spec guide_spec() {
  return base::Spec(
             "along guide",
             "Onto any body, along a line on it (a spine, the outside of an arm): the pattern's y runs along the "
             "line by its length, its x leaves the line at right angles along the shortest ways of the surface, "
             "so the panel is unstretched along the line and on both sides of it, as far as the body lets it.")
      .reals("guide", "mm",
             "Points x, y, z of the line, one after the other, on the body or near it, or landmarks. Beyond its ends "
             "it goes on "
             "straight along the surface.")
      .real("centre", "mm", "The pattern's x that lies on the line.", 0.0)
      .real("from", "mm", "The pattern's y that lies at the line's first point.", 0.0)
      .real("distance", "mm", "Of the panel from the body.", 0.0, base::Range::at_least(0.0));
}

/// A place on the surface, and a direction in it.
struct Heading {
  Vec3 at, normal, along;
};

/// Moves along the shortest ways of a surface.
class Walker {
 public:
  Walker(const base::List& list, const body::Surface& body) : list_(list), body_(body) {}

  Heading start(const Vec3& near, const Vec3& along) const {
    const body::SurfacePoint foot = body_.closest(near);
    if (!foot.found || std::abs(foot.gap) > body_.range()) {
      std::ostringstream text;
      text << "at (" << near[0] << ", " << near[1] << ", " << near[2]
           << ") mm the panel would lie off the body: draw the line nearer to it, or shorten the panel";
      list_.fail("guide", text.str());
    }
    const Vec3 tangent = along - along.dot(foot.normal) * foot.normal;
    return {foot.closest, foot.normal, tangent.normalized()};
  }

  /// Straight on for a length, mm; backwards if it is negative.
  Heading walk(Heading now, double length) const {
    const double sign = length < 0.0 ? -1.0 : 1.0;
    for (double left = std::abs(length); left > 1e-9;) {
      const double way = std::min(step, left);
      const Heading next = start(now.at + sign * way * now.along, now.along);
      left -= std::max((next.at - now.at).norm(), 0.1 * way);
      now = next;
    }
    return now;
  }

 private:
  const base::List& list_;
  const body::Surface& body_;
};

/// The line on the body, as places a step apart.
class Guide {
 public:
  Guide(const base::List& list, const Walker& walker) : walker_(walker) {
    const std::vector<Vec3> points = read_points(list);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const Vec3 way = points[k + 1] - points[k];
      const int parts = std::max(1, static_cast<int>(std::ceil(way.norm() / step)));
      for (int i = k == 0 ? 0 : 1; i <= parts; ++i) add(walker.start(points[k] + i * way / parts, way));
    }
    if (length_.back() <= 0.0) list.fail("guide", "has no length on the body");
    for (std::size_t k = 0; k < places_.size(); ++k) turn_along(k);
  }

  Heading at(double length) const {
    if (length <= 0.0) return walker_.walk(places_.front(), length);
    if (length >= length_.back()) return walker_.walk(places_.back(), length - length_.back());
    const auto after = std::upper_bound(length_.begin(), length_.end(), length);
    const std::size_t k = static_cast<std::size_t>(after - length_.begin());
    const double share = (length - length_[k - 1]) / (length_[k] - length_[k - 1]);
    const auto between = [&](const Vec3& a, const Vec3& b) { return Vec3((1.0 - share) * a + share * b); };
    return walker_.start(between(places_[k - 1].at, places_[k].at), between(places_[k - 1].along, places_[k].along));
  }

 private:
  static std::vector<Vec3> read_points(const base::List& list) {
    const base::Reals& values = list.reals("guide");
    if (values.size() < 6 || values.size() % 3 != 0)
      list.fail("guide",
                "has " + std::to_string(values.size()) + " numbers; it needs three for each of two or more points");
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < values.size(); k += 3) points.emplace_back(values[k], values[k + 1], values[k + 2]);
    return points;
  }
  void add(const Heading& place) {
    const double way = places_.empty() ? 0.0 : (place.at - places_.back().at).norm();
    length_.push_back(places_.empty() ? 0.0 : length_.back() + way);
    places_.push_back(place);
  }
  /// The way from the place before to the one after, which is the line's own where it bends.
  void turn_along(std::size_t k) {
    const Vec3 way = places_[std::min(k + 1, places_.size() - 1)].at - places_[k == 0 ? 0 : k - 1].at;
    Heading& here = places_[k];
    here.along = (way - way.dot(here.normal) * here.normal).normalized();
  }

  const Walker& walker_;
  std::vector<Heading> places_;
  std::vector<double> length_;  ///< [place] from the first one, mm
};

mesh::Placed place_along_guide(const base::List& list, const FlatPanel& panel) {
  if (panel.body == nullptr) list.fail("type", "\"along guide\" needs a body, and the scene has none");
  const Walker walker(list, *panel.body);
  const Guide guide(list, walker);
  mesh::Placed placed;
  for (const Vec2& node : panel.mesh.nodes) {
    const Heading on_line = guide.at(node.y() - list.real("from"));
    // The pattern's x, y and the outward normal are right-handed.
    const Heading across{on_line.at, on_line.normal, on_line.along.cross(on_line.normal)};
    const Heading end = walker.walk(across, node.x() - list.real("centre"));
    placed.normal.push_back(end.normal);
    placed.position.push_back(end.at + list.real("distance") * end.normal);
  }
  return placed;
}

}  // namespace

Placement guide_placement() {
  return {guide_spec(), place_along_guide, nullptr};
}

}  // namespace toile::garment
