#include "toile/mesh/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "toile/mesh/quadrature.hpp"

namespace toile::mesh {
namespace {

constexpr int pieces = 16;

std::vector<double> chord_lengths(const std::vector<Vec2>& points) {
  std::vector<double> knots{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) knots.push_back(knots.back() + (points[i] - points[i - 1]).norm());
  return knots;
}

/// Second derivatives of the natural cubic spline: the usual tridiagonal system, solved by forward elimination.
std::vector<Vec2> natural_second_derivatives(const std::vector<double>& knots, const std::vector<Vec2>& points) {
  const std::size_t n = points.size();
  std::vector<Vec2> second(n, Vec2::Zero());
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = knots[i] - knots[i - 1];
    const double after = knots[i + 1] - knots[i];
    const Vec2 jump = (points[i + 1] - points[i]) / after - (points[i] - points[i - 1]) / before;
    const double pivot = 2.0 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    second[i] = (6.0 * jump - before * second[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) second[i] -= upper[i] * second[i + 1];
  return second;
}

}  // namespace

Curve::Curve(const std::vector<Vec2>& points, Interpolation interpolation)
    : Curve(points, interpolation, chord_lengths(points)) {}

Curve::Curve(std::vector<Vec2> points, Interpolation interpolation, std::vector<double> parameters)
    : points_(std::move(points)), knots_(std::move(parameters)), second_(points_.size(), Vec2::Zero()) {
  assert(points_.size() >= 2 && points_.size() == knots_.size());
  if (interpolation == Interpolation::smooth) second_ = natural_second_derivatives(knots_, points_);
  tabulate_arc_length();
}

Curve::Curve(const Circle& circle)
    : circle_(circle),
      points_{circle.at(0.0), circle.at(1.0)},
      arc_{0.0, circle.radius * std::abs(circle.to - circle.from)} {}

Curve Curve::circular(const Vec2& centre, double radius, double from, double to) {
  return Curve(Circle{centre, radius, from, to});
}

Vec2 Curve::Circle::at(double s) const {
  const double angle = (1.0 - s) * from + s * to;
  return centre + radius * Vec2(std::cos(angle), std::sin(angle));
}

Vec2 Curve::value(int segment, double t) const {
  const double h = knots_[segment + 1] - knots_[segment];
  const double b = (t - knots_[segment]) / h;
  const double a = 1.0 - b;
  return a * points_[segment] + b * points_[segment + 1] +
         h * h / 6.0 * ((a * a * a - a) * second_[segment] + (b * b * b - b) * second_[segment + 1]);
}

Vec2 Curve::derivative(int segment, double t) const {
  const double h = knots_[segment + 1] - knots_[segment];
  const double b = (t - knots_[segment]) / h;
  const double a = 1.0 - b;
  return (points_[segment + 1] - points_[segment]) / h +
         h / 6.0 * ((1.0 - 3.0 * a * a) * second_[segment] + (3.0 * b * b - 1.0) * second_[segment + 1]);
}

double Curve::arc(int segment, double from, double to) const {
  return gauss_integral([this, segment](double t) { return derivative(segment, t).norm(); }, from, to);
}

void Curve::tabulate_arc_length() {
  arc_.assign(1, 0.0);
  for (int segment = 0; segment + 1 < static_cast<int>(knots_.size()); ++segment) {
    const double step = (knots_[segment + 1] - knots_[segment]) / pieces;
    for (int k = 0; k < pieces; ++k) {
      const double from = knots_[segment] + k * step;
      arc_.push_back(arc_.back() + arc(segment, from, from + step));
    }
  }
}

Vec2 Curve::at(double s) const {
  if (s <= 0.0) return points_.front();
  if (s >= 1.0) return points_.back();
  if (circle_) return circle_->at(s);
  const double wanted = s * length();
  const auto next = std::upper_bound(arc_.begin(), arc_.end(), wanted);
  const int piece = std::clamp(static_cast<int>(next - arc_.begin()) - 1, 0, static_cast<int>(arc_.size()) - 2);
  const int segment = piece / pieces;
  const double step = (knots_[segment + 1] - knots_[segment]) / pieces;
  const double from = knots_[segment] + (piece % pieces) * step;
  double t = from + step * (wanted - arc_[piece]) / (arc_[piece + 1] - arc_[piece]);
  for (int iteration = 0; iteration < 4; ++iteration) {
    const double speed = derivative(segment, t).norm();
    if (speed <= 0.0) break;
    t -= (arc_[piece] + arc(segment, from, t) - wanted) / speed;
    t = std::clamp(t, from, from + step);
  }
  return value(segment, t);
}

}  // namespace toile::mesh
