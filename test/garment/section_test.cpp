#include "section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lists.hpp"
#include "surfaces.hpp"

namespace toile::garment {
namespace {

using test::EllipticCylinder;
using test::input_error;

const Axis z_axis{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}};

double ellipse_girth(double a, double b) {
  return 4.0 * a * std::comp_ellint_2(std::sqrt(1.0 - b * b / (a * a)));
}

// The section of an ellipse has its exact girth.
TEST(Section, GirthOfEllipse) {
  const Section section = trace_section(EllipticCylinder(80.0, 50.0), z_axis, 30.0, 0.0);
  EXPECT_NEAR(section.girth(), ellipse_girth(80.0, 50.0), 1e-3);
}

// Every point of the section lies at the wanted distance from the surface, between the rays too.
TEST(Section, KeepsTheOffset) {
  const EllipticCylinder body(80.0, 50.0);
  const Section section = trace_section(body, z_axis, 30.0, 7.0);
  for (int k = 0; k < 1000; ++k) {
    const double angle = 2.0 * M_PI * k / 1000.0;
    EXPECT_NEAR(body.closest(z_axis.at(30.0) + section.radius(angle) * z_axis.ray(angle)).gap, 7.0, 1e-3);
  }
}

// Equal steps of arc length give equal chords, also across angle 0 and for negative arc lengths.
TEST(Section, IsParametrisedByArcLength) {
  const Section section = trace_section(EllipticCylinder(80.0, 50.0), z_axis, 0.0, 0.0);
  const auto at = [&section](double s) {
    const double angle = section.angle_at(s);
    return body::Vec3(section.radius(angle) * z_axis.ray(angle));
  };
  const double step = section.girth() / 2000.0;
  for (int k = -1000; k < 1000; ++k) EXPECT_NEAR((at((k + 1) * step) - at(k * step)).norm(), step, 1e-4 * step);
}

// An axis away from the middle finds the same section.
TEST(Section, DoesNotDependOnTheAxis) {
  Axis shifted = z_axis;
  shifted.origin = {25.0, 10.0, 0.0};
  const Section section = trace_section(EllipticCylinder(80.0, 50.0), shifted, 0.0, 0.0);
  EXPECT_NEAR(section.girth(), ellipse_girth(80.0, 50.0), 0.05);
}

// A body that only answers points near its surface is traced from deep inside.
TEST(Section, WorksWithLimitedReach) {
  const Section section = trace_section(test::Sphere(100.0, 15.0), z_axis, 60.0, 2.0);
  EXPECT_NEAR(section.radius(1.0), std::sqrt(102.0 * 102.0 - 60.0 * 60.0), 1e-6);
}

// An axis outside of the body is refused with the height.
TEST(Section, AxisOutsideIsRefused) {
  EXPECT_EQ(input_error([] { trace_section(test::Sphere(100.0, 200.0), z_axis, 120.0, 0.0); }),
            "the axis is not inside the body at the height 120 mm above \"axis bottom\"");
}

// A body without a surface in the direction of a ray is refused with the height.
TEST(Section, MissingSurfaceIsRefused) {
  EXPECT_EQ(input_error([] { trace_section(test::Endless(), z_axis, 5.0, 0.0); }),
            "a ray from the axis finds no surface of the body at the height 5 mm above \"axis bottom\"");
}

}  // namespace
}  // namespace toile::garment
