#include "toile/run/pierced.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace toile::run {

namespace {

using solve::Vec3;

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
      side_ = std::max(side_, (corners_[(i + 1) % n] - corners_[i]).norm());
      centre_ += corners_[i] / static_cast<double>(n);
    }
    for (size_t i = 0; i < n; ++i) normal_ += (corners_[i] - centre_).cross(corners_[(i + 1) % n] - centre_);
    normal_.stableNormalize();
  }

  double side() const { return side_; }

  /// How far the body sticks out of it, mm, at most its longest side; and where.
  double height(Vec3* where) const {
    std::vector<Vec3> places = {centre_};
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
    if (nearest >= -shallow() && nearest < side_ && towards_body(&from)) take(from, &height, where);
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

  /// The place of the element nearby that is farthest inside the body.
  Vec3 deepest(Vec3 point) const {
    body::SurfacePoint there = surface_.closest(point);
    for (double step = std::max(-there.gap, 0.1 * side_); step > shallow();) {
      const Vec3 next = closest(point - step * there.normal);
      const body::SurfacePoint further = surface_.closest(next);
      if (further.gap < there.gap) {
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
  double side_ = 0.0;
  Vec3 centre_ = Vec3::Zero(), normal_ = Vec3::Zero();
};

}  // namespace

Pierced pierced_elements(const solve::Problem& problem, const solve::Fields& fields) {
  constexpr double counts = 0.2, inside = -0.01;  // of the side; mm
  Pierced pierced;
  const body::Surface* surface = problem.surface;
  if (surface == nullptr) return pierced;
  for (const mesh::Block& block : problem.mesh->blocks) {
    const auto nodes = static_cast<size_t>(block.nodes_per_element);
    for (size_t first = 0; first < block.connectivity.size(); first += nodes) {
      std::vector<Vec3> corners;
      double nearest = HUGE_VAL;
      for (size_t i = first; i < first + nodes; ++i) {
        corners.push_back(fields.position[block.connectivity[i]]);
        nearest = std::min(nearest, fields.gap[block.connectivity[i]]);
      }
      const Element element(*surface, std::move(corners));
      // What is held inside the body is told by itself.
      if (nearest < inside || nearest > element.side()) continue;
      Vec3 where = Vec3::Zero();
      const double height = element.height(&where);
      const double share = element.side() > 0.0 ? height / element.side() : 0.0;
      if (share <= counts) continue;
      ++pierced.elements;
      if (share <= pierced.share) continue;
      pierced.height = height;
      pierced.share = share;
      pierced.where = where;
    }
  }
  return pierced;
}

}  // namespace toile::run
