#include "toile/pattern/curve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "toile/base/error.hpp"

namespace toile::pattern {
namespace {

const std::vector<Vec2> uneven{{0.0, 0.0}, {5.0, 8.0}, {40.0, 0.0}, {60.0, 30.0}};

/// Curves of every kind, none of them straight.
std::vector<Curve> curves() {
  return {Curve::spline(uneven),
          Curve::polyline(uneven),
          Curve::quadratic({0.0, 0.0}, {30.0, 60.0}, {100.0, 10.0}),
          Curve::cubic({0.0, 0.0}, {60.0, 80.0}, {-20.0, 90.0}, {50.0, 0.0}),
          Curve::circular({3.0, 4.0}, 50.0, 0.2, 2.9),
          Curve::circular({3.0, 4.0}, 50.0, 0.2, -5.0),
          Curve::joined({Curve::line({0.0, 0.0}, {10.0, 0.0}), Curve::circular({10.0, 20.0}, 20.0, -M_PI / 2, 0.5)})};
}

/// Derivative of the curve by its relative arc length, by central differences of fourth order.
Vec2 slope(const Curve& curve, double s) {
  constexpr double h = 1e-3;
  return (8.0 * (curve.at(s + h) - curve.at(s - h)) - (curve.at(s + 2 * h) - curve.at(s - 2 * h))) / (12.0 * h);
}

// A straight line is divided in proportion to its length.
TEST(Curve, StraightLineByArcLength) {
  const Curve line = Curve::line({1.0, 2.0}, {4.0, 6.0});
  EXPECT_DOUBLE_EQ(line.length(), 5.0);
  EXPECT_NEAR((line.at(0.3) - Vec2(1.9, 3.2)).norm(), 0.0, 1e-14);
}

// A polyline keeps its corners and its exact length.
TEST(Curve, PolylineKeepsCorners) {
  const Curve path = Curve::polyline({{0.0, 0.0}, {10.0, 0.0}, {10.0, 30.0}});
  EXPECT_DOUBLE_EQ(path.length(), 40.0);
  EXPECT_NEAR((path.at(0.25) - Vec2(10.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((path.at(0.5) - Vec2(10.0, 10.0)).norm(), 0.0, 1e-12);
  EXPECT_THAT(path.corners(0.1), testing::ElementsAre(testing::DoubleNear(0.25, 1e-12)));
  EXPECT_TRUE(Curve::spline(uneven).corners(1e-6).empty());
}

// The natural spline through (0,0), (1,1), (2,0) at the parameters 0, 1, 2 is y = 3t/2 - t^3/2 up to the middle.
TEST(Curve, SplineHasAnalyticValues) {
  const Curve curve = Curve::spline({{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}}, {0.0, 1.0, 2.0});
  for (const double s : {0.05, 0.2, 0.35, 0.5}) {
    const Vec2 p = curve.at(s);
    EXPECT_NEAR(p.y(), 1.5 * p.x() - 0.5 * p.x() * p.x() * p.x(), 1e-14);
  }
}

// The length of a natural spline through points of a half circle converges at least with second order.
TEST(Curve, SplineConvergesToCircle) {
  const auto miss = [](int n) {
    std::vector<Vec2> points;
    for (int i = 0; i <= n; ++i) points.emplace_back(50.0 * std::cos(i * M_PI / n), 50.0 * std::sin(i * M_PI / n));
    return std::abs(Curve::spline(points).length() - 50.0 * M_PI);
  };
  EXPECT_LT(miss(16), 0.05);
  EXPECT_GT(std::log2(miss(8) / miss(16)), 1.9);
}

// With given parameter values a coordinate that is linear in them stays linear.
TEST(Curve, GivenParametersKeepLinearCoordinate) {
  const Curve curve = Curve::spline({{0.0, 0.0}, {1.0, 100.0}, {0.0, 250.0}, {1.0, 400.0}}, {0.0, 100.0, 250.0, 400.0});
  double last = -1.0;
  for (int k = 0; k <= 50; ++k) {
    EXPECT_GT(curve.at(k / 50.0).y(), last);
    last = curve.at(k / 50.0).y();
  }
  EXPECT_DOUBLE_EQ(last, 400.0);
}

// Two points of a curve that are the same are refused with their place.
TEST(Curve, EqualNeighboursAreRefused) {
  try {
    Curve::spline({{0.0, 0.0}, {3.5, 1.0}, {3.5, 1.0}});
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "two points of a curve that follow each other are the same: (3.5, 1) mm; neighbours must be distinct");
  }
}

// The length agrees with adaptive quadrature of the speed, and the parameter is the arc length to 1e-10 of it.
TEST(Curve, ParameterIsArcLength) {
  for (const Curve& curve : curves()) {
    double before = 0.0;
    for (const double s : {0.1, 0.37, 0.5, 0.83, 1.0}) {
      double sum = 0.0;
      // Length of the part from its own segments, by a rule that Curve does not use.
      for (const Segment& segment : curve.part(0.0, s).segments()) {
        const auto speed = [&](double t) {
          if (const auto* arc = std::get_if<Arc>(&segment)) return arc->radius * std::abs(arc->to - arc->from);
          const auto& c = std::get<Bezier>(segment).control;
          return 3.0 *
                 ((1 - t) * (1 - t) * (c[1] - c[0]) + 2 * t * (1 - t) * (c[2] - c[1]) + t * t * (c[3] - c[2])).norm();
        };
        sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(speed, 0.0, 1.0, 12, 1e-13);
      }
      EXPECT_NEAR(sum / curve.length(), s, 1e-10);
      EXPECT_GT(sum, before);
      before = sum;
    }
  }
}

// The tangent is the derivative by arc length.
TEST(Curve, TangentIsDerivative) {
  for (const Curve& curve : curves())
    for (const double s : {0.07, 0.31, 0.48, 0.9})
      EXPECT_NEAR((curve.tangent(s) * curve.length() - slope(curve, s)).norm(), 0.0, 2e-5 * curve.length());
}

// Quadratic and cubic Bezier curves have their exact values, here at t = 1/2 by symmetry, and tangents at their ends.
TEST(Curve, BezierIsExact) {
  const Curve quadratic = Curve::quadratic({-10.0, 0.0}, {0.0, 20.0}, {10.0, 0.0});
  EXPECT_NEAR((quadratic.at(0.5) - Vec2(0.0, 10.0)).norm(), 0.0, 1e-13);
  // y = 10 - x^2 / 10: its length is x sqrt(1 + 4 a^2 x^2) + asinh(2 a x) / (2 a) at x = 10, a = 0.1.
  EXPECT_NEAR(quadratic.length(), 10.0 * std::sqrt(5.0) + 5.0 * std::asinh(2.0), 1e-11);
  const Curve cubic = Curve::cubic({-10.0, 0.0}, {-10.0, 8.0}, {10.0, 8.0}, {10.0, 0.0});
  EXPECT_NEAR((cubic.at(0.5) - Vec2(0.0, 6.0)).norm(), 0.0, 1e-13);
  EXPECT_NEAR((cubic.tangent(0.0) - Vec2(0.0, 1.0)).norm(), 0.0, 1e-15);
}

// A control point on an end leaves the tangent there: it points to the next control point.
TEST(Curve, DegenerateBezierHasTangents) {
  const Vec2 a(0.0, 0.0), b(30.0, 40.0), c(100.0, 0.0);
  const Curve start = Curve::cubic(a, a, b, c), end = Curve::cubic(a, b, c, c), line = Curve::cubic(a, a, c, c);
  EXPECT_NEAR((start.tangent(0.0) - Vec2(0.6, 0.8)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((start.tangent(1e-9) - Vec2(0.6, 0.8)).norm(), 0.0, 1e-3);
  EXPECT_NEAR((end.tangent(1.0) - Vec2(70.0, -40.0).normalized()).norm(), 0.0, 1e-14);
  EXPECT_NEAR((line.tangent(0.0) - Vec2(1.0, 0.0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((line.tangent(1.0) - Vec2(1.0, 0.0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((line.at(0.25) - Vec2(25.0, 0.0)).norm(), 0.0, 1e-8);
}

// A circular arc is exact in either direction and closes after a full turn.
TEST(Curve, CircularArcIsExact) {
  const Curve back = Curve::circular({1.0, 2.0}, 50.0, M_PI / 2, M_PI / 6);
  EXPECT_NEAR(back.length(), 50.0 * M_PI / 3, 1e-12);
  EXPECT_NEAR((back.front() - Vec2(1.0, 52.0)).norm(), 0.0, 1e-13);
  EXPECT_NEAR((back.at(0.5) - Vec2(26.0, 2.0 + 25.0 * std::sqrt(3.0))).norm(), 0.0, 1e-13);
  const Curve turn = Curve::circular({0.0, 0.0}, 50.0, 0.0, 2.0 * M_PI);
  EXPECT_NEAR((turn.front() - turn.back()).norm(), 0.0, 1e-13);
}

// The four arcs of one radius through two points have the lengths and sides that their names say.
TEST(Curve, ArcsBetweenTwoPoints) {
  const Vec2 a(0.0, 0.0), b(10.0, 0.0);
  const double radius = 10.0 / std::sqrt(2.0);  // a quarter and three quarters of a circle
  for (const bool longer : {false, true})
    for (const bool left : {false, true}) {
      const Curve arc = Curve::circular(a, b, radius, longer, left);
      EXPECT_NEAR(arc.length(), (longer ? 1.5 : 0.5) * M_PI * radius, 1e-12);
      EXPECT_NEAR((arc.front() - a).norm() + (arc.back() - b).norm(), 0.0, 1e-13);
      // Counter-clockwise from left to right the arc passes below the chord.
      const double height = longer ? radius + 5.0 : radius - 5.0;
      EXPECT_NEAR(arc.at(0.5).y(), left ? -height : height, 1e-12);
    }
  EXPECT_THROW(Curve::circular(a, b, 4.9, false, true), base::InputError);
}

// Reversing, moving, mirroring and cutting give the same points of every kind of curve.
TEST(Curve, TransformedCurves) {
  const Vec2 point(3.0, -2.0), axis = Vec2(2.0, 1.0).normalized(), shift(5.0, 7.0);
  const Eigen::Rotation2Dd turn(0.7);
  for (const Curve& curve : curves())
    for (const double s : {0.0, 0.21, 0.64, 1.0}) {
      const Vec2 p = curve.at(s), d = p - point;
      EXPECT_NEAR((curve.reversed().at(1.0 - s) - p).norm(), 0.0, 1e-9);
      EXPECT_NEAR((curve.moved(0.7, shift).at(s) - (turn * p + shift)).norm(), 0.0, 1e-9);
      EXPECT_NEAR((curve.mirrored(point, axis).at(s) - (point + 2.0 * d.dot(axis) * axis - d)).norm(), 0.0, 1e-9);
      EXPECT_NEAR((curve.part(0.2, 0.7).at(s) - curve.at(0.2 + 0.5 * s)).norm(), 0.0, 3e-11 * curve.length());
    }
}

// Straight lines between the points of a curve keep within the tolerance of it.
TEST(Curve, PointsKeepWithinTolerance) {
  for (const Curve& curve : curves())
    for (const double tolerance : {1.0, 0.01}) {
      const std::vector<Vec2> points = curve.points(tolerance);
      for (std::size_t k = 1; k < points.size(); ++k) {
        const Vec2 middle = 0.5 * (points[k - 1] + points[k]);
        EXPECT_LT((curve.at(nearest(curve, middle)) - middle).norm(), 1.001 * tolerance);
      }
    }
}

// The nearest point of a curve to one beside it is the foot of the perpendicular.
TEST(Curve, NearestIsFootOfPerpendicular) {
  const Curve arc = Curve::circular({0.0, 0.0}, 50.0, 0.0, M_PI);
  EXPECT_NEAR(nearest(arc, {30.0 * std::cos(0.6), 30.0 * std::sin(0.6)}), 0.6 / M_PI, 1e-7);
}

}  // namespace
}  // namespace toile::pattern
