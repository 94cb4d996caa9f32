#include "toile/mesh/curve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace toile::mesh {
namespace {

std::vector<Vec2> arc_points(int n) {
  std::vector<Vec2> points;
  for (int i = 0; i <= n; ++i) points.emplace_back(50.0 * std::cos(i * M_PI / n), 50.0 * std::sin(i * M_PI / n));
  return points;
}

// A straight line is divided in proportion to its length.
TEST(Curve, StraightLineByArcLength) {
  const Curve line({{1.0, 2.0}, {4.0, 6.0}}, Interpolation::smooth);
  EXPECT_DOUBLE_EQ(line.length(), 5.0);
  EXPECT_NEAR((line.at(0.3) - Vec2(1.9, 3.2)).norm(), 0.0, 1e-12);
}

// A polyline keeps its corners and its exact length.
TEST(Curve, PolylineKeepsCorners) {
  const Curve path({{0.0, 0.0}, {10.0, 0.0}, {10.0, 30.0}}, Interpolation::polyline);
  EXPECT_DOUBLE_EQ(path.length(), 40.0);
  EXPECT_NEAR((path.at(0.25) - Vec2(10.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((path.at(0.5) - Vec2(10.0, 10.0)).norm(), 0.0, 1e-12);
}

// A smooth curve passes through the given points.
TEST(Curve, SmoothCurveInterpolates) {
  const std::vector<Vec2> points{{0.0, 0.0}, {10.0, 5.0}, {25.0, 0.0}, {30.0, -20.0}};
  const Curve curve(points, Interpolation::smooth);
  for (const Vec2& point : points) {
    double nearest = 1e9;
    for (int k = 0; k <= 4000; ++k) nearest = std::min(nearest, (curve.at(k / 4000.0) - point).norm());
    EXPECT_LT(nearest, 0.01);
  }
}

// The length of a smooth curve through points of a half circle converges at least with second order.
TEST(Curve, SmoothCurveConvergesToCircle) {
  const double coarse = std::abs(Curve(arc_points(8), Interpolation::smooth).length() - 50.0 * M_PI);
  const double fine = std::abs(Curve(arc_points(16), Interpolation::smooth).length() - 50.0 * M_PI);
  EXPECT_LT(fine, 0.05);
  EXPECT_GT(std::log2(coarse / fine), 1.9);
}

// A circular arc is exact at any number of points, in either direction, and closes after a full turn.
TEST(Curve, CircularArcIsExact) {
  const Curve back = Curve::circular({1.0, 2.0}, 50.0, M_PI / 2, M_PI / 6);
  EXPECT_NEAR(back.length(), 50.0 * M_PI / 3, 1e-12);
  EXPECT_NEAR((back.front() - Vec2(1.0, 52.0)).norm(), 0.0, 1e-13);
  EXPECT_NEAR((back.at(0.5) - Vec2(26.0, 2.0 + 25.0 * std::sqrt(3.0))).norm(), 0.0, 1e-13);
  EXPECT_EQ(back.at(1.0), back.back());
  const Curve turn = Curve::circular({0.0, 0.0}, 50.0, 0.0, 2.0 * M_PI);
  EXPECT_NEAR((turn.front() - turn.back()).norm(), 0.0, 1e-13);
}

// Equal steps of the parameter are equal steps of arc length on a curve with uneven points.
TEST(Curve, ParameterIsArcLength) {
  const Curve curve({{0.0, 0.0}, {5.0, 8.0}, {40.0, 0.0}, {60.0, 30.0}}, Interpolation::smooth);
  constexpr int n = 20000;
  double longest = 0.0, shortest = 1e9;
  for (int k = 0; k < n; ++k) {
    const double step = (curve.at((k + 1.0) / n) - curve.at(static_cast<double>(k) / n)).norm();
    longest = std::max(longest, step);
    shortest = std::min(shortest, step);
  }
  EXPECT_NEAR(longest, curve.length() / n, 1e-5 * curve.length() / n);
  EXPECT_NEAR(shortest, curve.length() / n, 1e-5 * curve.length() / n);
}

// With given parameter values a coordinate that is linear in them stays linear.
TEST(Curve, GivenParametersKeepLinearCoordinate) {
  const std::vector<Vec2> points{{10.0, 0.0}, {17.0, 100.0}, {15.0, 250.0}, {26.0, 400.0}};
  const Curve curve(points, Interpolation::smooth, {0.0, 100.0, 250.0, 400.0});
  double last = -1.0;
  for (int k = 0; k <= 50; ++k) {
    EXPECT_GT(curve.at(k / 50.0).y(), last);
    last = curve.at(k / 50.0).y();
  }
  EXPECT_DOUBLE_EQ(last, 400.0);
}

}  // namespace
}  // namespace toile::mesh
