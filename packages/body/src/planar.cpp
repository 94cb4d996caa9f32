#include "planar.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace toile::body {
namespace {

using Vec2 = Eigen::Vector2d;

/// Foot in the first quadrant with a >= b: the root t > -b^2 of the convex, decreasing
/// F(t) = (a x/(t + a^2))^2 + (b y/(t + b^2))^2 - 1 (Eberly, "Distance from a point to an ellipse", 2013).
/// Newton from a point left of the root approaches it monotonically.
Vec2 ellipse_foot(double a, double b, double x, double y) {
  if (y <= 0.0 && x * a <= a * a - b * b) {
    const double fx = a > b ? a * a * x / (a * a - b * b) : 0.0;
    return {fx, b * std::sqrt(std::max(0.0, 1.0 - fx * fx / (a * a)))};
  }
  double t = std::max(b * (y - b), a * (x - a));
  for (int i = 0; i < 100; ++i) {
    const double u = a * x / (t + a * a);
    const double v = y > 0.0 ? b * y / (t + b * b) : 0.0;
    const double f = u * u + v * v - 1.0;
    const double slope = -2.0 * (u * u / (t + a * a) + (y > 0.0 ? v * v / (t + b * b) : 0.0));
    const double step = -f / slope;
    t += step;
    if (std::abs(step) <= 1e-15 * a * a) {
      break;
    }
  }
  return {a * a * x / (t + a * a), y > 0.0 ? b * b * y / (t + b * b) : 0.0};
}

double ellipse_curvature(double a, double b, const Vec2& foot) {
  const double c = foot.x() / a;
  const double s = foot.y() / b;
  return a * b / std::pow(a * a * s * s + b * b * c * c, 1.5);
}

/// Closest point where the meridian has passed the axis at `beyond`, in a straight line: the tip, seen as a ball of no
/// size. Its offset surfaces are spheres, so that half a thickness of fabric rounds it.
PlanarPoint closest_on_tip(const Profile::Value& value, double beyond, const Vec2& point) {
  constexpr double curvature = 1e12;  // 1/mm
  PlanarPoint tip;
  tip.foot = {0.0, beyond - value.radius / value.slope};
  tip.gap = (point - tip.foot).norm();
  tip.normal = tip.gap > 0.0 ? Vec2((point - tip.foot) / tip.gap) : Vec2(0.0, value.slope < 0.0 ? 1.0 : -1.0);
  tip.curvature = curvature;
  return tip;
}

/// Interval around the global minimum of the squared distance to the meridian. The foot is at most |rho - r(z)| above
/// or below the point, because the point of the meridian at its own height is that near.
std::pair<double, double> bracket(const Profile& profile, const Vec2& point) {
  const double width = std::abs(point.x() - profile.at(point.y()).radius);
  const int n = static_cast<int>(std::clamp(std::ceil(2.0 * width / profile.variation()), 1.0, 400.0));
  const double lower = point.y() - width;
  const double step = 2.0 * width / n;
  int best = 0;
  double least = HUGE_VAL;
  for (int i = 0; i <= n; ++i) {
    const double z = lower + i * step;
    const double distance = (point - Vec2(profile.at(z).radius, z)).squaredNorm();
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return {lower + std::max(best - 1, 0) * step, lower + std::min(best + 1, n) * step};
}

}  // namespace

PlanarPoint closest_on_ellipse(double a, double b, const Vec2& point) {
  const Vec2 p = point.cwiseAbs();
  Vec2 foot = a >= b ? ellipse_foot(a, b, p.x(), p.y()) : ellipse_foot(b, a, p.y(), p.x());
  if (a < b) {
    std::swap(foot.x(), foot.y());
  }
  PlanarPoint result;
  result.foot = {std::copysign(foot.x(), point.x()), std::copysign(foot.y(), point.y())};
  result.normal = Vec2(result.foot.x() / (a * a), result.foot.y() / (b * b)).normalized();
  result.curvature = ellipse_curvature(a, b, foot);
  result.gap = result.normal.dot(point - result.foot);
  return result;
}

PlanarPoint closest_on_profile(const Profile& profile, const Vec2& point) {
  auto [lower, upper] = bracket(profile, point);
  double z = std::clamp(point.y(), lower, upper);
  Profile::Value value = profile.at(z);
  for (int i = 0; i < 100; ++i) {
    const double d = point.x() - value.radius;
    const double slope = z - point.y() - d * value.slope;  // half the derivative of the squared distance
    const double curvature = 1.0 + value.slope * value.slope - d * value.bend;
    (slope > 0.0 ? upper : lower) = z;
    double next = curvature > 0.0 ? z - slope / curvature : HUGE_VAL;
    if (!(next >= lower && next <= upper)) {
      next = 0.5 * (lower + upper);
    }
    const double step = std::abs(next - z);
    z = next;
    value = profile.at(z);
    if (step <= 1e-14 * (1.0 + std::abs(z))) {
      break;
    }
  }
  if (value.radius < 0.0 && value.slope != 0.0) return closest_on_tip(value, z, point);
  PlanarPoint result;
  const double length = std::hypot(1.0, value.slope);
  result.foot = {value.radius, z};
  result.normal = Vec2(1.0, -value.slope) / length;
  result.curvature = -value.bend / (length * length * length);
  result.gap = result.normal.dot(point - result.foot);
  return result;
}

}  // namespace toile::body
