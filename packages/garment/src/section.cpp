#include "section.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::garment {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 7>;

constexpr int rays = 128;
constexpr double largest_radius = 2000.0;  // mm; no section of a body is wider
constexpr double tolerance = 1e-8;         // mm
constexpr int most_steps = 500;

/// Of the radii at neighbouring angles. An ellipse of 5 to 1 has 1.13, an axis at a hundredth of a circle's radius from
/// its rim 1.4; a fold that the axis cannot see behind makes a jump.
constexpr double largest_ratio = 1.6;

[[noreturn]] void fail(const std::string& what, const Axis& axis, double height) {
  std::ostringstream text;
  text << what << " at the height " << height << " mm above " << axis.start;
  throw base::InputError(text.str());
}

/// The ray goes in and out of the body again, and ends nowhere.
[[noreturn]] void fail_in_fold(const Axis& axis, double height, double angle) {
  std::ostringstream text;
  text.precision(4);
  text << "the body has a groove or slit too narrow to be wrapped (a panel that spans it is placed by \"free wrap\") "
       << "near " << angle * 180.0 / M_PI << " degrees from \"zero direction\"";
  fail(text.str(), axis, height);
}

/// Radius at which the gap along the ray at the angle equals `offset`; `start` is known not to lie beyond it. The gap
/// is a distance, so a step by what is missing never passes the surface; close to it the slope of the gap along the ray
/// makes it Newton's step.
double trace_ray(const body::Surface& body, const Axis& axis, double height, double angle, double start,
                 double offset) {
  const body::Vec3 origin = axis.at(height), ray = axis.ray(angle);
  double radius = start;
  bool was_beyond = false;
  for (int step = 0; step < most_steps && radius < largest_radius; ++step) {
    const body::SurfacePoint point = body.closest(origin + radius * ray);
    const double missing = offset - point.gap;
    if (point.found && std::abs(missing) <= tolerance) return radius;
    if (!point.found) {  // deep inside: the gap is a bound of the distance
      radius += std::abs(missing);
      continue;
    }
    was_beyond = was_beyond || missing < 0.0;
    const double slope = point.normal.dot(ray);
    const bool near = std::abs(missing) < 0.1 * radius && slope > 0.3;
    radius += near ? missing / slope : missing;
  }
  if (was_beyond && radius < largest_radius) fail_in_fold(axis, height, angle);
  fail("a ray from the axis finds no surface of the body", axis, height);
}

/// Depth of the axis inside the body, mm: no ray meets the surface before.
double depth_of(const body::Surface& body, const Axis& axis, double height) {
  const double gap = body.closest(axis.at(height)).gap;
  if (gap >= 0.0) fail("the axis is not inside the body", axis, height);
  return -gap;
}

}  // namespace

body::Vec3 Axis::ray(double angle) const {
  return std::cos(angle) * zero + std::sin(angle) * direction.cross(zero);
}

Section::Section(std::vector<double> radii)
    : step_(2.0 * M_PI / static_cast<double>(radii.size())), radii_(std::move(radii)), arc_(1, 0.0) {
  const std::size_t n = radii_.size();
  const auto at = [this, n](std::size_t i) { return radii_[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    slopes_.push_back((at(i + n - 2) - 8.0 * at(i + n - 1) + 8.0 * at(i + 1) - at(i + 2)) / (12.0 * step_));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double from = static_cast<double>(i) * step_;
    arc_.push_back(arc_.back() + arc(from, from + step_));
  }
}

Section::Local Section::local(double angle) const {
  const auto n = static_cast<int>(radii_.size());
  const double sample = angle / step_;
  const int before = std::clamp(static_cast<int>(std::floor(sample)), 0, n - 1);
  const int after = (before + 1) % n;
  const double t = sample - before;
  const double s = 1.0 - t;
  const double a = radii_[before], b = radii_[after];
  const double da = slopes_[before] * step_, db = slopes_[after] * step_;
  // Hermite interpolation.
  return {s * s * ((1.0 + 2.0 * t) * a + t * da) + t * t * ((1.0 + 2.0 * s) * b - s * db),
          (6.0 * s * t * (b - a) + s * (s - 2.0 * t) * da + t * (t - 2.0 * s) * db) / step_};
}

double Section::radius(double angle) const {
  return local(angle).radius;
}

double Section::arc(double from, double to) const {
  return Gauss::integrate([this](double angle) { return std::hypot(local(angle).radius, local(angle).slope); }, from,
                          to);
}

double Section::angle_at(double s) const {
  const double wanted = s - std::floor(s / girth()) * girth();
  const auto next = std::upper_bound(arc_.begin(), arc_.end(), wanted);
  const int sample = std::clamp(static_cast<int>(next - arc_.begin()) - 1, 0, static_cast<int>(radii_.size()) - 1);
  const double from = sample * step_;
  double angle = from + step_ * (wanted - arc_[sample]) / (arc_[sample + 1] - arc_[sample]);
  for (int iteration = 0; iteration < 3; ++iteration) {
    const Local here = local(angle);
    angle -= (arc_[sample] + arc(from, angle) - wanted) / std::hypot(here.radius, here.slope);
    angle = std::clamp(angle, from, from + step_);
  }
  return angle;
}

std::optional<Section::Fold> Section::fold_between(double from, double to) const {
  const auto n = static_cast<int>(radii_.size());
  const double turns = std::floor(from / girth());
  for (double turn = turns; turn * girth() < to; turn += 1.0)
    for (int k = 0; k < n; ++k) {
      if (turn * girth() + arc_[k + 1] <= from || turn * girth() + arc_[k] >= to) continue;
      const double a = radii_[k], b = radii_[(k + 1) % n];
      if (std::max(a, b) > largest_ratio * std::min(a, b)) return Fold{k * step_, a, b};
    }
  return std::nullopt;
}

Section trace_section(const body::Surface& body, const Axis& axis, double height, double offset) {
  const double depth = depth_of(body, axis, height);
  std::vector<double> radii;
  for (int k = 0; k < rays; ++k) {
    radii.push_back(trace_ray(body, axis, height, 2.0 * M_PI * k / rays, depth, offset));
  }
  return Section(std::move(radii));
}

double trace_radius(const body::Surface& body, const Axis& axis, double height, double angle, double offset) {
  return trace_ray(body, axis, height, angle, depth_of(body, axis, height), offset);
}

}  // namespace toile::garment
