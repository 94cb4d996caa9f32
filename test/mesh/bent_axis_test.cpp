#include "toile/mesh/bent_axis.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "toile/base/error.hpp"

namespace toile::mesh {
namespace {

constexpr double w = 100.0;  // mm

/// A right angle in the y-z plane, with the corner spread over w to either side.
BentAxis right_angle() {
  return BentAxis({Vec3(0, 0, -150), Vec3(0, 0, 0), Vec3(0, 150, 0)}, w);
}

// A right angle becomes a parabola of known place, length and radius, and stays straight beyond it.
TEST(BentAxis, RoundsARightAngleToAParabola) {
  const BentAxis axis = right_angle();
  const double bend = w * (1.0 + std::asinh(1.0) / std::sqrt(2.0));
  EXPECT_NEAR(axis.length(), 100.0 + bend, 1e-9);
  const BentAxis::Place corner = axis.at(50.0 + 0.5 * bend);
  EXPECT_NEAR((corner.point - Vec3(0, w / 4, -w / 4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((corner.direction - Vec3(0, 1, 1) / std::sqrt(2.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((corner.curvature - Vec3(0, 1, -1) / w).norm(), 0.0, 1e-12);
  EXPECT_NEAR((axis.at(-20.0).point - Vec3(0, 0, -170)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((axis.at(30.0).point - Vec3(0, 0, -120)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((axis.at(axis.length() + 30.0).point - Vec3(0, 180, 0)).norm(), 0.0, 1e-9);
}

/// Three bends in different planes.
BentAxis spatial() {
  return BentAxis({Vec3(0, 0, 0), Vec3(0, 0, 90), Vec3(0, 80, 120), Vec3(70, 90, 160), Vec3(90, 20, 230)}, 45.0);
}

// Places are measured by arc length, and the tangent and the curvature are its derivatives.
TEST(BentAxis, IsMeasuredByItsArcLength) {
  const BentAxis axis = spatial();
  constexpr double h = 1e-3;
  for (double s = -60.0; s < axis.length() + 60.0; s += 3.7) {
    const Vec3 chord = (axis.at(s + h).point - axis.at(s - h).point) / (2.0 * h);
    const Vec3 bend = (axis.at(s + h).direction - axis.at(s - h).direction) / (2.0 * h);
    EXPECT_NEAR((chord - axis.at(s).direction).norm(), 0.0, 1e-6) << s;
    EXPECT_NEAR((bend - axis.at(s).curvature).norm(), 0.0, 1e-5) << s;
  }
}

// Directions are carried along as a rigid body that follows the tangent and does not twist about it.
TEST(BentAxis, CarriesDirectionsWithoutATwist) {
  const BentAxis axis = spatial();
  constexpr double h = 1e-3;
  for (double s = -10.0; s < axis.length(); s += 3.7) {
    const BentAxis::Place here = axis.at(s), next = axis.at(s + h);
    EXPECT_NEAR((here.turn * axis.at(0.0).direction - here.direction).norm(), 0.0, 1e-9);
    EXPECT_NEAR((here.turn * here.turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
    const Eigen::Matrix3d rate = (next.turn * here.turn.transpose() - Eigen::Matrix3d::Identity()) / h;
    const Vec3 spin(rate(2, 1), rate(0, 2), rate(1, 0));
    EXPECT_NEAR(spin.dot(here.direction), 0.0, 1e-5) << s;
  }
}

// Where the axis turns back on itself it has no tangent, which is told with the place.
TEST(BentAxis, AHairpinIsRefused) {
  try {
    const BentAxis hairpin({Vec3(0, 0, 0), Vec3(0, 0, 100), Vec3(0, 0.1, 0)}, 50.0);
    ADD_FAILURE() << "no InputError";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("the axis turns back on itself near (0, "));
  }
}

}  // namespace
}  // namespace toile::mesh
