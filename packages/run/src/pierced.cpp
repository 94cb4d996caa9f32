#include "toile/run/pierced.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "toile/body/triangle_tree.hpp"

namespace toile::run {

namespace {

using solve::Vec3;

constexpr double told_from = 0.2;  // of the side

/// The point of the triangle a, b, c that is closest to p. Of a triangle without area: that of its sides.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, w = p - a;
  Eigen::Matrix2d gram;
  gram << u.dot(u), u.dot(v), u.dot(v), v.dot(v);
  const Eigen::Vector2d share = gram.fullPivLu().solve(Eigen::Vector2d(u.dot(w), v.dot(w)));
  if (gram.determinant() > 0.0 && share.minCoeff() >= 0.0 && share.sum() <= 1.0) return a + share[0] * u + share[1] * v;
  Vec3 best = a;
  for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const Vec3 side = to - from;
    const double along =
        side.squaredNorm() > 0.0 ? std::clamp((p - from).dot(side) / side.squaredNorm(), 0.0, 1.0) : 0.0;
    const Vec3 here = from + along * side;
    if ((here - p).norm() < (best - p).norm()) best = here;
  }
  return best;
}

/// The corners of one element, and what the body is beside it.
class Element {
 public:
  Element(const body::Surface& surface, std::vector<Vec3> corners) : surface_(surface), corners_(std::move(corners)) {
    const size_t n = corners_.size();
    for (size_t i = 0; i < n; ++i) {
      longest_ = std::max(longest_, (corners_[(i + 1) % n] - corners_[i]).norm());
      centre_ += corners_[i] / static_cast<double>(n);
    }
    for (size_t i = 0; i < n; ++i) normal_ += (corners_[i] - centre_).cross(corners_[(i + 1) % n] - centre_);
    // Twice the area; that of a triangle is half of its square's.
    side_ = std::sqrt(normal_.norm() * (n == 3 ? 1.0 : 0.5));
    normal_.stableNormalize();
  }

  const std::vector<Vec3>& corners() const { return corners_; }
  const Vec3& centre() const { return centre_; }
  double side() const { return side_; }        ///< mean: of a square of its area, mm
  double longest() const { return longest_; }  ///< side, mm

  /// How far the body sticks out of it, mm, at most its side; and where. `places`: of it, inside the body.
  double height(std::vector<Vec3> places, Vec3* where) const {
    places.push_back(centre_);
    for (size_t i = 0; i < corners_.size(); ++i)
      places.push_back(0.5 * (corners_[i] + corners_[(i + 1) % corners_.size()]));
    double height = 0.0, nearest = HUGE_VAL;
    Vec3 from = centre_;
    for (const Vec3& place : places) {
      const double gap = surface_.closest(place).gap;
      if (gap < nearest) from = place;
      nearest = std::min(nearest, gap);
      if (gap < -shallow()) take(place, &height, where);
    }
    if (nearest >= -shallow() && nearest < longest_ && towards_body(&from)) take(from, &height, where);
    return height;
  }

 private:
  /// What a smooth body does between nodes that touch it, mm.
  double shallow() const { return 0.01 * side_; }

  void take(const Vec3& inside, double* height, Vec3* where) const {
    const Vec3 deep = deepest(inside);
    const double here = height_at(deep);
    if (here <= *height) return;
    *height = here;
    *where = deep;
  }

  /// The place of the element nearby that is farthest inside the body, to some hundredths of a side.
  Vec3 deepest(Vec3 point) const {
    constexpr int turns = 30;
    body::SurfacePoint there = surface_.closest(point);
    double step = std::max(-there.gap, 0.1 * side_);
    for (int turn = 0; turn < turns && step > shallow(); ++turn) {
      const Vec3 next = closest(point - step * there.normal);
      const body::SurfacePoint further = surface_.closest(next);
      if (further.gap < there.gap - 0.1 * shallow()) {
        point = next;
        there = further;
      } else {
        step *= 0.5;
      }
    }
    return point;
  }

  /// Way out of the body along the normal, to the side on which it is shorter.
  double height_at(const Vec3& inside) const {
    double least = side_;
    for (const double sense : {1.0, -1.0}) {
      double way = 0.0;
      while (way < least) {
        const double gap = surface_.closest(inside + sense * way * normal_).gap;
        if (gap >= 0.0) break;
        way += std::max(-gap, shallow());
      }
      least = std::min(least, way);
    }
    return least;
  }

  /// From a point of the element outside the body to one inside it, by turns the closest of the body and of the
  /// element, and a short way further; false: the way does not lead into it.
  bool towards_body(Vec3* point) const {
    constexpr int turns = 10;
    for (int turn = 0; turn < turns; ++turn) {
      const body::SurfacePoint there = surface_.closest(*point);
      if (there.gap < -shallow()) return true;
      if (!there.found) return false;
      const Vec3 next = closest(there.closest - 2.0 * shallow() * there.normal);
      if ((next - *point).norm() < shallow()) return false;
      *point = next;
    }
    return false;
  }

  /// Its point that is closest to p.
  Vec3 closest(const Vec3& p) const {
    Vec3 best = centre_;
    for (size_t i = 0; i < corners_.size(); ++i) {
      const Vec3 here = closest_on_triangle(p, centre_, corners_[i], corners_[(i + 1) % corners_.size()]);
      if ((here - p).norm() < (best - p).norm()) best = here;
    }
    return best;
  }

  const body::Surface& surface_;
  std::vector<Vec3> corners_;
  double side_ = 0.0, longest_ = 0.0;
  Vec3 centre_ = Vec3::Zero(), normal_ = Vec3::Zero();
};

/// Of all blocks, in their order.
std::vector<Element> elements_of(const mesh::Mesh& mesh, const body::Surface& surface,
                                 const std::vector<Vec3>& position) {
  std::vector<Element> all;
  for (const mesh::Block& block : mesh.blocks)
    for (auto node = block.connectivity.begin(); node != block.connectivity.end(); node += block.nodes_per_element) {
      std::vector<Vec3> corners;
      std::transform(node, node + block.nodes_per_element, std::back_inserter(corners),
                     [&](int n) { return position[n]; });
      all.emplace_back(surface, std::move(corners));
    }
  return all;
}

/// [element] its places below vertices of the body that are off the fabric: where a tip is narrower than what lies
/// between the places that are looked at in every element, they lead to it. Those outside the body are left out.
std::vector<std::vector<Vec3>> below_vertices(const body::Surface& surface, const std::vector<Element>& elements) {
  body::TriangleMesh fabric;
  std::vector<size_t> of_triangle;
  double sides = 0.0;
  for (size_t e = 0; e < elements.size(); ++e) {
    const std::vector<Vec3>& corners = elements[e].corners();
    const auto first = static_cast<int>(fabric.vertices.size());
    fabric.vertices.insert(fabric.vertices.end(), corners.begin(), corners.end());
    for (int i = 2; i < static_cast<int>(corners.size()); ++i) {
      fabric.triangles.push_back({first, first + i - 1, first + i});
      of_triangle.push_back(e);
    }
    sides += elements[e].side();
  }
  std::vector<std::vector<Vec3>> places(elements.size());
  const body::TriangleTree tree(fabric);
  // Of a body that a formula gives: vertices enough for what a quarter of an element misses.
  const double size = 0.25 * sides / static_cast<double>(elements.size());
  for (const Vec3& vertex : surface.triangles(size).vertices) {
    const body::TriangleTree::Hit hit = tree.closest(vertex);
    const size_t e = of_triangle[static_cast<size_t>(hit.triangle)];
    if (hit.distance < told_from * elements[e].side()) continue;
    if (surface.closest(hit.point).gap < 0.0) places[e].push_back(hit.point);
  }
  return places;
}

/// Elements whose way from where they were placed to where they are, in a straight line, leads through the body.
int passed_elements(const std::vector<Element>& placed, const std::vector<Element>& elements,
                    const body::Surface& surface) {
  int passed = 0;
  for (size_t e = 0; e < elements.size(); ++e) {
    const Vec3 from = placed[e].centre(), way = elements[e].centre() - from;
    const double length = way.norm(), least = 0.01 * length;
    double deepest = 0.0;
    for (double at = 0.0; at < length;) {
      const double gap = surface.closest(from + at / length * way).gap;
      deepest = std::min(deepest, gap);
      at += std::max(std::abs(gap), least);
    }
    if (deepest < -least) ++passed;
  }
  return passed;
}

}  // namespace

Pierced pierced_elements(const solve::Problem& problem, const solve::Fields& fields) {
  constexpr double inside = -0.01;  // mm
  Pierced pierced;
  const mesh::Mesh& mesh = *problem.mesh;
  if (problem.surface == nullptr || mesh.elements() == 0) return pierced;
  const std::vector<Element> elements = elements_of(mesh, *problem.surface, fields.position);
  const auto presses = [](double pressure) { return pressure > 0.0; };
  if (std::none_of(fields.pressure.begin(), fields.pressure.end(), presses))
    pierced.passed = passed_elements(elements_of(mesh, *problem.surface, mesh.placed), elements, *problem.surface);
  const std::vector<std::vector<Vec3>> places = below_vertices(*problem.surface, elements);
  size_t e = 0;
  for (const mesh::Block& block : mesh.blocks)
    for (auto node = block.connectivity.begin(); node != block.connectivity.end();
         node += block.nodes_per_element, ++e) {
      double nearest = HUGE_VAL;
      for (int i = 0; i < block.nodes_per_element; ++i) nearest = std::min(nearest, fields.gap[node[i]]);
      // What is held inside the body is told by itself.
      if (nearest < inside || nearest > elements[e].longest()) continue;
      Vec3 where = Vec3::Zero();
      const double height = elements[e].height(places[e], &where);
      const double share = elements[e].side() > 0.0 ? height / elements[e].side() : 0.0;
      if (share <= told_from) continue;
      ++pierced.elements;
      if (share <= pierced.share) continue;
      pierced.height = height;
      pierced.share = share;
      pierced.where = where;
    }
  return pierced;
}

}  // namespace toile::run
