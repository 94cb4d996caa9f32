#include "straighten.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "skin_curve.hpp"

namespace toile::scene {

namespace {

using body::Vec3;
using Points = std::vector<Vec3>;

/// Product of the principal curvatures, 1/mm^2: the Hessian of the distance has them and 0 as its eigenvalues.
double gauss_curvature(const body::Mat3& hessian) {
  return 0.5 * (hessian.trace() * hessian.trace() - hessian.squaredNorm());
}

/// Solves a symmetric system whose diagonals are `diagonal` and the constant `beside`, which dominate.
std::vector<double> solve_tridiagonal(std::vector<double> diagonal, double beside, std::vector<double> right) {
  for (size_t i = 1; i < right.size(); ++i) {
    const double factor = beside / diagonal[i - 1];
    diagonal[i] -= factor * beside;
    right[i] -= factor * right[i - 1];
  }
  for (size_t i = right.size(); i-- > 0;) {
    if (i + 1 < right.size()) right[i] -= beside * right[i + 1];
    right[i] /= diagonal[i];
  }
  return right;
}

/// Points at equal distances along a way, the first and the last among them.
Points evened(const Points& way, size_t parts) {
  const std::vector<double> lengths = lengths_along(way);
  Points even = {way.front()};
  for (size_t i = 1; i < parts; ++i)
    even.push_back(point_at(way, lengths, lengths.back() * static_cast<double>(i) / static_cast<double>(parts)));
  even.push_back(way.back());
  return even;
}

bool lay_on(const body::Surface& surface, Points& way, std::vector<body::SurfacePoint>& feet) {
  feet.clear();
  for (Vec3& point : way) {
    feet.push_back(surface.closest(point));
    if (!feet.back().found) return false;
    point = feet.back().closest;
  }
  return true;
}

/// One step to the side within the surface, which would take the geodesic curvature away: its second variation is
/// w'' + K w, of which a positive K is left out, so that the matrix stays definite.
void step_aside(Points& way, const std::vector<body::SurfacePoint>& feet) {
  std::vector<double> diagonal, curvature;
  Points aside;
  const double step = (way[1] - way[0]).norm();
  for (size_t i = 1; i + 1 < way.size(); ++i) {
    aside.push_back(feet[i].normal.cross(way[i + 1] - way[i - 1]).normalized());
    curvature.push_back(aside.back().dot(way[i + 1] - 2.0 * way[i] + way[i - 1]));
    diagonal.push_back(2.0 + step * step * std::max(0.0, -gauss_curvature(feet[i].hessian)));
  }
  const std::vector<double> moves = solve_tridiagonal(std::move(diagonal), -1.0, std::move(curvature));
  for (size_t i = 0; i < moves.size(); ++i) way[i + 1] += moves[i] * aside[i];
}

}  // namespace

Points straightened(const body::Surface& surface, const Points& way, double step) {
  constexpr int most_steps = 200;
  constexpr double settled = 1e-9;  // of the length
  const double start = lengths_along(way).back();
  const auto parts = static_cast<size_t>(std::max(4.0, std::ceil(start / step)));
  std::vector<body::SurfacePoint> feet;
  Points tight = evened(way, parts);
  if (!lay_on(surface, tight, feet)) return {};
  double length = lengths_along(tight).back();
  for (int k = 0; k < most_steps; ++k) {
    tight = evened(tight, parts);
    if (!lay_on(surface, tight, feet)) return {};
    step_aside(tight, feet);
    if (!lay_on(surface, tight, feet)) return {};
    const double before = length;
    length = lengths_along(tight).back();
    if (std::abs(before - length) < settled * length) return tight;
  }
  return {};
}

}  // namespace toile::scene
