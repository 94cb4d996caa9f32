#include "toile/body/analytic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "parametric_grid.hpp"
#include "planar.hpp"

namespace toile::body {
namespace {

/// Below this share of a radius of curvature that is left, the closest point is about to lose its uniqueness.
constexpr double least_share = 1e-3;

/// Factor of the principal curvature k in the Hessian of the gap at distance g; false where it is singular.
bool offset_curvature(double k, double g, double* result) {
  const double share = 1.0 + g * k;
  *result = k / share;
  return share > least_share;
}

std::string shown_text(const Span& shown) {
  std::ostringstream text;
  text << ", shown from z = " << shown.bottom << " to " << shown.top << " mm, exact smooth surface";
  return text.str();
}

/// A surface that is rotated about z, from the closest point in its meridian plane.
class RotatedSurface : public Surface {
 public:
  SurfacePoint closest(const Vec3& point) const override {
    const double rho = std::hypot(point.x(), point.y());
    const PlanarPoint planar = meridian({rho, point.z()});
    const Vec3 radial = rho > 0.0 ? Vec3(point.x() / rho, point.y() / rho, 0.0) : Vec3::UnitX();
    const Vec3 hoop(-radial.y(), radial.x(), 0.0);
    const Vec3 tangent = -planar.normal.y() * radial + planar.normal.x() * Vec3::UnitZ();
    SurfacePoint result;
    result.gap = planar.gap;
    result.normal = planar.normal.x() * radial + planar.normal.y() * Vec3::UnitZ();
    result.closest = planar.foot.x() * radial + planar.foot.y() * Vec3::UnitZ();
    double along = 0.0;
    bool regular = offset_curvature(planar.curvature, planar.gap, &along);
    // Hoop curvature n_r/r at the foot, n_r/rho at the point; both tend to the meridian's at a pole.
    const bool pole = rho < 1e-9 * (1.0 + std::abs(point.z())) && planar.foot.x() < least_share;
    const double around = pole ? along : planar.normal.x() / rho;
    regular = regular && (pole || rho > least_share * planar.foot.x()) && planar.foot.x() >= 0.0;
    if (regular) {
      result.hessian = along * tangent * tangent.transpose() + around * hoop * hoop.transpose();
      result.found = true;
    }
    return result;
  }

 private:
  virtual PlanarPoint meridian(const Eigen::Vector2d& point) const = 0;
};

class Revolution final : public RotatedSurface {
 public:
  Revolution(ProfilePtr profile, Span shown, std::string name)
      : profile_(std::move(profile)), shown_(shown), name_(std::move(name)) {
    constexpr int samples = 400;
    for (int i = 0; i <= samples; ++i) {
      const auto value = profile_->at(shown_.bottom + (shown_.top - shown_.bottom) * i / samples);
      greatest_radius_ = std::max(greatest_radius_, value.radius);
      const double bend = std::abs(value.bend) / std::pow(1.0 + value.slope * value.slope, 1.5);
      range_ = std::min({range_, 0.5 * value.radius, bend > 0.0 ? 0.5 / bend : range_});
    }
  }
  double range() const override { return range_; }
  TriangleMesh triangles(double size) const override {
    const int rows = divisions(shown_.top - shown_.bottom, size, 1);
    const int columns = divisions(2.0 * M_PI * greatest_radius_, size, 12);
    return tube(columns, rows, [this](double u, double v) -> Vec3 {
      const double z = shown_.bottom + v * (shown_.top - shown_.bottom);
      const double r = profile_->at(z).radius;
      return {r * std::cos(2.0 * M_PI * u), r * std::sin(2.0 * M_PI * u), z};
    });
  }
  std::string summary() const override { return name_ + shown_text(shown_); }

 private:
  PlanarPoint meridian(const Eigen::Vector2d& point) const override { return closest_on_profile(*profile_, point); }

  ProfilePtr profile_;
  Span shown_;
  std::string name_;
  double range_ = std::numeric_limits<double>::infinity();
  double greatest_radius_ = 0.0;
};

class Ellipsoid final : public RotatedSurface {
 public:
  Ellipsoid(double radius, double half_height) : a_(radius), b_(half_height) {}
  double range() const override { return 0.5 * std::min(a_ * a_ / b_, b_ * b_ / a_); }
  TriangleMesh triangles(double size) const override {
    const int rows = divisions(M_PI * std::max(a_, b_), size, 8);
    const int columns = divisions(2.0 * M_PI * a_, size, 12);
    return capped_tube(columns, rows, [this](double u, double v) -> Vec3 {
      const double latitude = M_PI * (v - 0.5);
      const double r = a_ * std::cos(latitude);
      return {r * std::cos(2.0 * M_PI * u), r * std::sin(2.0 * M_PI * u), b_ * std::sin(latitude)};
    });
  }
  std::string summary() const override {
    std::ostringstream text;
    if (a_ == b_) {
      text << "sphere of radius " << a_ << " mm, exact smooth surface";
    } else {
      text << "ellipsoid of radius " << a_ << " mm and half height " << b_ << " mm, exact smooth surface";
    }
    return text.str();
  }

 private:
  PlanarPoint meridian(const Eigen::Vector2d& point) const override { return closest_on_ellipse(a_, b_, point); }

  double a_, b_;
};

class EllipticCylinder final : public Surface {
 public:
  EllipticCylinder(double a, double b, Span shown) : a_(a), b_(b), shown_(shown) {}
  SurfacePoint closest(const Vec3& point) const override {
    const PlanarPoint planar = closest_on_ellipse(a_, b_, point.head<2>());
    SurfacePoint result;
    result.gap = planar.gap;
    result.normal = {planar.normal.x(), planar.normal.y(), 0.0};
    result.closest = {planar.foot.x(), planar.foot.y(), point.z()};
    const Vec3 tangent(-planar.normal.y(), planar.normal.x(), 0.0);
    double around = 0.0;
    if (offset_curvature(planar.curvature, planar.gap, &around)) {
      result.hessian = around * tangent * tangent.transpose();
      result.found = true;
    }
    return result;
  }
  double range() const override { return 0.5 * std::min(a_ * a_ / b_, b_ * b_ / a_); }
  TriangleMesh triangles(double size) const override {
    const int rows = divisions(shown_.top - shown_.bottom, size, 1);
    const int columns = divisions(2.0 * M_PI * std::max(a_, b_), size, 12);
    return tube(columns, rows, [this](double u, double v) -> Vec3 {
      return {a_ * std::cos(2.0 * M_PI * u), b_ * std::sin(2.0 * M_PI * u),
              shown_.bottom + v * (shown_.top - shown_.bottom)};
    });
  }
  std::string summary() const override {
    std::ostringstream text;
    text << "elliptic cylinder with semi-axes " << a_ << " and " << b_ << " mm" << shown_text(shown_);
    return text.str();
  }

 private:
  double a_, b_;
  Span shown_;
};

}  // namespace

SurfacePtr revolution(ProfilePtr profile, Span shown, const std::string& name) {
  return std::make_shared<Revolution>(std::move(profile), shown, name);
}

SurfacePtr elliptic_cylinder(double a, double b, Span shown) {
  return std::make_shared<EllipticCylinder>(a, b, shown);
}

SurfacePtr ellipsoid(double radius, double half_height) {
  return std::make_shared<Ellipsoid>(radius, half_height);
}

}  // namespace toile::body
