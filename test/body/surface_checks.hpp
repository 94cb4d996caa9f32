#pragma once

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <random>

#include "toile/body/surface.hpp"

namespace toile::test {

/// Largest differences between derivatives and central finite differences, over random points near a surface.
struct DerivativeErrors {
  double normal = 0.0;           ///< of grad gap
  double hessian = 0.0;          ///< of grad normal, 1/mm
  double largest_hessian = 0.0;  ///< largest entry seen: the comparison must not be of zeros
  int inside = 0;                ///< points tested inside
  int outside = 0;
};

/// Points: `start(random)` gives one in the neighbourhood of the surface, moved to a gap within [lower, upper].
template <class Start>
DerivativeErrors derivative_errors(const body::Surface& surface, int points, double lower, double upper, double step,
                                   const Start& start) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> gap(lower, upper);
  DerivativeErrors errors;
  for (int n = 0; n < points; ++n) {
    const body::SurfacePoint foot = surface.closest(start(random));
    EXPECT_TRUE(foot.found);
    const body::Vec3 x = foot.closest + gap(random) * foot.normal;
    const body::SurfacePoint here = surface.closest(x);
    EXPECT_TRUE(here.found) << x.transpose();
    (here.gap < 0.0 ? errors.inside : errors.outside)++;
    for (int axis = 0; axis < 3; ++axis) {
      const body::Vec3 shift = step * body::Vec3::Unit(axis);
      const body::SurfacePoint next = surface.closest(x + shift), last = surface.closest(x - shift);
      errors.normal = std::max(errors.normal, std::abs((next.gap - last.gap) / (2.0 * step) - here.normal[axis]));
      const body::Vec3 column = (next.normal - last.normal) / (2.0 * step);
      errors.hessian = std::max(errors.hessian, (column - here.hessian.col(axis)).cwiseAbs().maxCoeff());
    }
    errors.largest_hessian = std::max(errors.largest_hessian, here.hessian.cwiseAbs().maxCoeff());
  }
  return errors;
}

/// Largest principal curvature of the surface at the foot of `point`, 1/mm.
inline double largest_curvature(const body::Surface& surface, const body::Vec3& point) {
  const body::SurfacePoint foot = surface.closest(surface.closest(point).closest);
  EXPECT_TRUE(foot.found);
  return Eigen::SelfAdjointEigenSolver<body::Mat3>(foot.hessian).eigenvalues()[2];
}

}  // namespace toile::test
