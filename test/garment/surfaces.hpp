#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "toile/body/surface.hpp"

namespace toile::garment::test {

/// Bodies with a closed-form distance, for the placement only: no Hessian, no triangles.
class AnalyticSurface : public body::Surface {
 public:
  double range() const override { return std::numeric_limits<double>::infinity(); }
  body::TriangleMesh triangles(double) const override { return {}; }
  std::string summary() const override { return "analytic surface of a test"; }
};

/// Elliptic cylinder about the z axis (a circular one for a = b): closest point by bisection (Eberly).
class EllipticCylinder : public AnalyticSurface {
 public:
  EllipticCylinder(double a, double b) : a_(a), b_(b) {}

  body::SurfacePoint closest(const body::Vec3& point) const override {
    const double x = std::abs(point.x()), y = std::abs(point.y());
    const auto root = [this, x, y](double t) {
      const double u = a_ * x / (t + a_ * a_), v = b_ * y / (t + b_ * b_);
      return u * u + v * v - 1.0;
    };
    double low = -b_ * b_ + b_ * y, high = -b_ * b_ + std::hypot(a_ * x, b_ * y) + 1e-9;
    for (int k = 0; k < 200; ++k) (root(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    const double t = 0.5 * (low + high);
    body::Vec3 on(x > 0.0 ? a_ * a_ * x / (t + a_ * a_) : 0.0, y > 0.0 ? b_ * b_ * y / (t + b_ * b_) : 0.0, point.z());
    if (y == 0.0) on.y() = b_ * std::sqrt(std::max(0.0, 1.0 - on.x() * on.x() / (a_ * a_)));
    on = {std::copysign(on.x(), point.x()), std::copysign(on.y(), point.y()), point.z()};
    body::SurfacePoint result;
    result.closest = on;
    result.normal = body::Vec3(on.x() / (a_ * a_), on.y() / (b_ * b_), 0.0).normalized();
    result.gap = (point - on).dot(result.normal);
    result.found = true;
    return result;
  }

 private:
  double a_, b_;  // a_ >= b_
};

/// Sphere round the origin that answers only points within `reach` of its surface, as a body with a search limit does.
class Sphere : public AnalyticSurface {
 public:
  Sphere(double radius, double reach) : radius_(radius), range_(reach) {}
  double range() const override { return range_; }

  body::SurfacePoint closest(const body::Vec3& point) const override {
    body::SurfacePoint result;
    const double gap = point.norm() - radius_;
    result.found = std::abs(gap) <= range_;
    result.gap = result.found ? gap : std::copysign(range_, gap);
    if (!result.found) return result;
    result.normal = point.normalized();
    result.closest = radius_ * result.normal;
    return result;
  }

 private:
  double radius_, range_;
};

/// Inside of everything: a body whose surface no ray finds.
class Endless : public AnalyticSurface {
 public:
  body::SurfacePoint closest(const body::Vec3&) const override {
    body::SurfacePoint result;
    result.gap = -10.0;
    return result;
  }
};

}  // namespace toile::garment::test
