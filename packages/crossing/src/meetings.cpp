#include "meetings.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace toile::crossing {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

Kernel::Point_3 exact(const Vec3& p) {
  return {p[0], p[1], p[2]};
}

Kernel::Triangle_3 exact(const Triangle& t) {
  return {exact(t[0]), exact(t[1]), exact(t[2])};
}

/// The sides of a triangle's plane on which the corners of another one lie: -1, 0, 1; and their distances times twice
/// its area.
struct Sides {
  std::array<int, 3> sign;
  std::array<double, 3> distance;

  Sides(const Triangle& plane, const Triangle& corners) {
    const Vec3 normal = (plane[1] - plane[0]).cross(plane[2] - plane[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      sign[i] = CGAL::orientation(exact(plane[0]), exact(plane[1]), exact(plane[2]), exact(corners[i]));
      distance[i] = normal.dot(corners[i] - plane[0]);
    }
  }
  /// Of all corners, the plane itself included for two at most.
  bool one() const { return sign[0] != 0 && sign[0] == sign[1] && sign[1] == sign[2]; }
};

/// Adds where the sides of `edges` meet the triangle `face`. A side in its plane gives none: its ends, and where it
/// leaves the face, belong to other sides.
void add_points(const Triangle& edges, const Triangle& face, const Sides& sides, std::vector<Vec3>& points) {
  const Kernel::Triangle_3 triangle = exact(face);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (sides.sign[i] == sides.sign[j]) continue;
    if (!CGAL::do_intersect(Kernel::Segment_3(exact(edges[i]), exact(edges[j])), triangle)) continue;
    const double from = sides.sign[i] == 0 ? 0.0 : std::abs(sides.distance[i]),
                 to = sides.sign[j] == 0 ? 0.0 : std::abs(sides.distance[j]);
    const double part = from + to > 0.0 ? from / (from + to) : 0.5;
    points.push_back(edges[i] + part * (edges[j] - edges[i]));
  }
}

/// The line in which two triangles meet.
std::optional<Segment> common(const Triangle& a, const Triangle& b) {
  const Sides b_of_a(a, b);
  if (b_of_a.one()) return std::nullopt;
  const Sides a_of_b(b, a);
  if (a_of_b.one()) return std::nullopt;
  std::vector<Vec3> points;
  add_points(b, a, b_of_a, points);
  add_points(a, b, a_of_b, points);
  std::optional<Segment> longest;
  double length = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if ((points[i] - points[j]).norm() <= length) continue;
      length = (points[i] - points[j]).norm();
      longest = Segment{points[j], points[i]};
    }
  return longest;
}

std::vector<Box> boxes(const Fabric& fabric) {
  std::vector<Box> all;
  for (int e = 0; e < fabric.elements(); ++e) {
    CGAL::Bbox_3 box;
    for (const int node : fabric.nodes(e)) box += exact(fabric.at(node)).bbox();
    all.emplace_back(box, e);
  }
  return all;
}

}  // namespace

std::vector<Meeting> find_meetings(const Fabric& fabric) {
  std::vector<Box> all = boxes(fabric);
  std::vector<std::vector<Triangle>> triangles;
  for (int e = 0; e < fabric.elements(); ++e) triangles.push_back(fabric.triangles(e));
  std::vector<Meeting> meetings;
  CGAL::box_self_intersection_d(all.begin(), all.end(), [&](const Box& one, const Box& other) {
    Meeting meeting{std::min(one.info(), other.info()), std::max(one.info(), other.info()), {}};
    if (fabric.joined(meeting.first, meeting.second)) return;
    for (const Triangle& a : triangles[meeting.first])
      for (const Triangle& b : triangles[meeting.second])
        if (const auto segment = common(a, b)) meeting.segments.push_back(*segment);
    if (!meeting.segments.empty()) meetings.push_back(std::move(meeting));
  });
  // The search picks at random, what it finds it does not.
  std::sort(meetings.begin(), meetings.end(), [](const Meeting& a, const Meeting& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return meetings;
}

double height_above(const std::vector<Triangle>& triangles, const Vec3& point) {
  constexpr double beside = 2.0;  // squared distance over squared height: 45 degrees
  double nearest = std::numeric_limits<double>::infinity(), height = 0.0;
  for (const Triangle& t : triangles) {
    const double distance = CGAL::squared_distance(exact(point), exact(t));
    if (distance >= nearest) continue;
    nearest = distance;
    height = (t[1] - t[0]).cross(t[2] - t[0]).normalized().dot(point - t[0]);
  }
  return nearest <= beside * height * height ? height : 0.0;
}

}  // namespace toile::crossing
