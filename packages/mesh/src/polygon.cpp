#include "toile/mesh/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace toile::mesh {
namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool boxes_apart(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
         std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y());
}

/// Common point of the closed segments ab and cd.
std::optional<Vec2> intersection(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (boxes_apart(a, b, c, d)) return std::nullopt;
  const Vec2 ab = b - a;
  const Vec2 cd = d - c;
  const double side_a = cross(cd, a - c);
  const double side_b = cross(cd, b - c);
  const double side_c = cross(ab, c - a);
  const double side_d = cross(ab, d - a);
  if (side_a * side_b > 0.0 || side_c * side_d > 0.0) return std::nullopt;
  if (side_a == side_b) return std::max(a, c, [](const Vec2& p, const Vec2& q) { return p.x() < q.x(); });  // collinear
  return a + side_a / (side_a - side_b) * ab;
}

/// Two consecutive sides p-q, q-r that run back over each other.
bool folds_back(const Vec2& p, const Vec2& q, const Vec2& r) {
  const Vec2 in = q - p;
  const Vec2 out = r - q;
  return in.dot(out) < 0.0 && std::abs(cross(in, out)) <= 1e-12 * in.norm() * out.norm();
}

}  // namespace

double signed_area(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return 0.5 * twice;
}

std::optional<Vec2> find_self_intersection(const std::vector<Vec2>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % n];
    if (folds_back(a, b, polygon[(i + 2) % n])) return b;
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;  // neighbours across the closing point
      if (auto point = intersection(a, b, polygon[k], polygon[(k + 1) % n])) return point;
    }
  }
  return std::nullopt;
}

}  // namespace toile::mesh
