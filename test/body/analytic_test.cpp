#include "toile/body/analytic.hpp"

#include <cmath>

#include "body/surface_checks.hpp"

namespace toile::body {
namespace {

using Random = std::mt19937;

/// Points around the z axis at the given distance, z in the given range.
auto around_axis(double radius, double bottom, double top) {
  return [=](Random& random) -> Vec3 {
    std::uniform_real_distribution<double> z(bottom, top), angle(0.0, 2.0 * M_PI);
    const double t = angle(random);
    return {radius * std::cos(t), radius * std::sin(t), z(random)};
  };
}

struct Case {
  std::string name;
  SurfacePtr surface;
  double radius, bottom, top;  ///< where points are drawn
};

SurfacePtr default_leg() {
  const double turn = 2.0 * M_PI;
  return revolution(spline_profile({114.0, 334.0, 423.0, 728.0}, {205 / turn, 340 / turn, 310 / turn, 520 / turn},
                                   LowerEnd::mirrored),
                    {80.0, 760.0}, "leg");
}

std::vector<Case> cases() {
  const Span span{0.0, 200.0};
  return {{"cylinder", revolution(linear_profile(50.0, 0.0), span, "cylinder"), 50.0, -50.0, 250.0},
          {"cone", revolution(linear_profile(60.0, -0.2), span, "cone"), 50.0, 0.0, 150.0},
          {"cosine", revolution(cosine_profile(60.0, 8.0, 150.0), span, "cosine"), 60.0, 0.0, 200.0},
          {"profile", revolution(spline_profile({0.0, 60.0, 200.0}, {50.0, 65.0, 40.0}), span, "profile"), 55.0, -20.0,
           220.0},
          {"leg", default_leg(), 55.0, 0.0, 760.0},
          {"sphere", ellipsoid(70.0, 70.0), 40.0, -60.0, 60.0},
          {"oblate", ellipsoid(90.0, 60.0), 40.0, -60.0, 60.0},
          {"prolate", ellipsoid(60.0, 90.0), 40.0, -60.0, 60.0},
          {"elliptic cylinder", elliptic_cylinder(80.0, 50.0, span), 65.0, 0.0, 200.0},
          {"elliptic cylinder, long axis y", elliptic_cylinder(50.0, 80.0, span), 65.0, 0.0, 200.0}};
}

// Normal and Hessian of every body given by a formula are the derivatives of its gap, inside and outside.
TEST(Analytic, DerivativesMatchFiniteDifferences) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const auto errors =
        test::derivative_errors(*c.surface, 200, -12.0, 20.0, 1e-4, around_axis(c.radius, c.bottom, c.top));
    EXPECT_LT(errors.normal, 1e-8);
    EXPECT_LT(errors.hessian, 1e-7);
    EXPECT_GT(errors.largest_hessian, 1e-3);
    EXPECT_GT(errors.inside, 20);
    EXPECT_GT(errors.outside, 20);
  }
}

// The closest point, the gap and the normal belong together: x = closest + gap normal, and the closest point has gap 0.
TEST(Analytic, ClosestPointLiesOnTheSurfaceAlongTheNormal) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    Random random(3);
    const auto draw = around_axis(c.radius, c.bottom, c.top);
    for (int i = 0; i < 200; ++i) {
      const Vec3 x = 1.1 * draw(random);
      const SurfacePoint p = c.surface->closest(x);
      ASSERT_TRUE(p.found);
      EXPECT_LT((p.closest + p.gap * p.normal - x).norm(), 1e-11);
      EXPECT_LT(std::abs(c.surface->closest(p.closest).gap), 1e-11);
      EXPECT_NEAR(p.normal.norm(), 1.0, 1e-14);
    }
  }
}

// The gap to a cylinder and to a sphere is the distance to the axis or the centre less the radius, at any distance.
TEST(Analytic, KnownDistances) {
  const auto cylinder = revolution(linear_profile(50.0, 0.0), {0.0, 1.0}, "cylinder");
  const auto sphere = ellipsoid(70.0, 70.0);
  for (const double rho : {1.0, 20.0, 49.99, 50.01, 80.0, 1000.0}) {
    const Vec3 x(0.6 * rho, -0.8 * rho, 30.0);
    EXPECT_NEAR(cylinder->closest(x).gap, rho - 50.0, 1e-12 * rho + 1e-13);
    EXPECT_NEAR(sphere->closest(x).gap, x.norm() - 70.0, 1e-12 * rho + 1e-13);
  }
}

// Distances to the ellipse and to the cosine body are the global minimum, also where several local ones compete.
TEST(Analytic, ClosestPointIsTheGlobalMinimum) {
  const auto ellipse = elliptic_cylinder(80.0, 50.0, {0.0, 1.0});
  const auto waist = revolution(cosine_profile(60.0, 20.0, 100.0), {0.0, 200.0}, "cosine");
  Random random(5);
  std::uniform_real_distribution<double> coordinate(-120.0, 120.0);
  for (int n = 0; n < 60; ++n) {
    const Vec3 x(coordinate(random), coordinate(random), coordinate(random));
    double to_ellipse = HUGE_VAL, to_waist = HUGE_VAL;
    for (int i = 0; i < 100000; ++i) {
      const double t = 2.0 * M_PI * i / 100000.0;
      to_ellipse = std::min(to_ellipse, std::hypot(80.0 * std::cos(t) - x.x(), 50.0 * std::sin(t) - x.y()));
      const double z = x.z() + 200.0 * (i / 50000.0 - 1.0);
      const double r = 60.0 + 20.0 * std::cos(2.0 * M_PI * z / 100.0);
      to_waist = std::min(to_waist, std::hypot(r - std::hypot(x.x(), x.y()), z - x.z()));
    }
    EXPECT_NEAR(std::abs(ellipse->closest(x).gap), to_ellipse, 1e-4);
    EXPECT_NEAR(std::abs(waist->closest(x).gap), to_waist, 1e-4);
  }
}

// Beyond the tip of a cone, at either end, the gap is the distance to the tip, with its derivatives, on the axis too;
// beside the cone it is the distance to the flank.
TEST(Analytic, TipOfACone) {
  const double half = std::sqrt(0.5);
  for (const double up : {1.0, -1.0}) {
    const auto cone = revolution(linear_profile(60.0, -up), {-10.0, 10.0}, "cone");
    for (const Vec3& off : {Vec3(0.3, -0.4, 1.2), Vec3(0.0, 0.0, 1.3), Vec3(0.0, 0.0, 1e-4), Vec3(3.0, 4.0, 5.1)}) {
      const Vec3 from(off.x(), off.y(), up * off.z());
      const SurfacePoint p = cone->closest(Vec3(0.0, 0.0, up * 60.0) + from);
      const Vec3 n = from.normalized();
      EXPECT_TRUE(p.found);
      EXPECT_NEAR(p.gap / from.norm(), 1.0, 1e-9);
      EXPECT_LT((p.normal - n).norm(), 1e-9);
      EXPECT_LT((p.hessian * from.norm() - (Mat3::Identity() - n * n.transpose())).norm(), 1e-6);
    }
    EXPECT_NEAR(cone->closest(Vec3(5.0, 0.0, up * 58.0)).gap, 3.0 * half, 1e-12);
  }
}

// On the axis, where the gap has no derivative, the answer is "not found" with the right negative gap, not a number
// without meaning.
TEST(Analytic, AxisIsOutOfReach) {
  const auto cylinder = revolution(linear_profile(50.0, 0.0), {0.0, 1.0}, "cylinder");
  for (const auto& [surface, gap] : {std::pair(cylinder, -50.0), std::pair(ellipsoid(70.0, 70.0), -70.0)}) {
    const SurfacePoint p = surface->closest(Vec3::Zero());
    EXPECT_FALSE(p.found);
    EXPECT_NEAR(p.gap, gap, 1e-12);
    EXPECT_TRUE(p.hessian.allFinite());
  }
}

// The leg has exactly the demanded girths at their levels and the smallest one at the ankle.
TEST(Leg, HasItsGirths) {
  const auto leg = default_leg();
  for (const auto& [level, girth] :
       {std::pair(114.0, 205.0), std::pair(334.0, 340.0), std::pair(423.0, 310.0), std::pair(728.0, 520.0)}) {
    EXPECT_NEAR(leg->closest({girth / (2.0 * M_PI), 0.0, level}).gap, 0.0, 1e-12);
  }
}

// The leg's profile does not overshoot: between ankle and calf it stays within their girths to 1 %, between knee and
// thigh likewise.
TEST(Leg, DoesNotOvershoot) {
  const double turn = 2.0 * M_PI;
  const auto profile = spline_profile({114.0, 334.0, 423.0, 728.0}, {205 / turn, 340 / turn, 310 / turn, 520 / turn},
                                      LowerEnd::mirrored);
  for (double z = 114.0; z <= 334.0; z += 1.0) {
    EXPECT_GE(profile->at(z).radius, 205.0 / turn - 1e-12);
    EXPECT_LE(profile->at(z).radius, 1.01 * 340.0 / turn);
  }
  for (double z = 334.0; z <= 728.0; z += 1.0) {
    EXPECT_GE(profile->at(z).radius, 0.98 * 310.0 / turn);
    EXPECT_LE(profile->at(z).radius, 520.0 / turn + 1e-12);
  }
}

// Spline profiles are curvature-continuous at the levels, at both ends and beyond: no jump of r, r' or r''.
TEST(Profile, IsC2) {
  for (const LowerEnd end : {LowerEnd::straight, LowerEnd::mirrored}) {
    const std::vector<double> levels{10.0, 60.0, 100.0, 180.0};
    const auto profile = spline_profile(levels, {30.0, 50.0, 45.0, 70.0}, end);
    for (const double z : {10.0, 60.0, 100.0, 180.0, -160.0}) {
      const auto below = profile->at(z - 1e-7), above = profile->at(z + 1e-7);
      EXPECT_NEAR(below.radius, above.radius, 1e-6);
      EXPECT_NEAR(below.slope, above.slope, 1e-8);
      EXPECT_NEAR(below.bend, above.bend, 1e-9);
    }
    EXPECT_GT(std::abs(profile->at(60.0).bend), 1e-3);
  }
}

// Pictures: every triangle vertex lies on the surface and the triangles look outwards.
TEST(Analytic, TrianglesLieOnTheSurface) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const TriangleMesh mesh = c.surface->triangles(8.0);
    ASSERT_GT(mesh.triangles.size(), 100u);
    for (const Vec3& vertex : mesh.vertices) {
      EXPECT_NEAR(c.surface->closest(vertex).gap, 0.0, 1e-10);
    }
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], d = mesh.vertices[t[2]];
      EXPECT_GT((b - a).cross(d - a).dot(c.surface->closest(a).normal), 0.0);
    }
  }
}

}  // namespace
}  // namespace toile::body
