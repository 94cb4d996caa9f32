#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "verification/contact_reference.hpp"
#include "verification/print.hpp"

namespace toile::test {
namespace {

/// Half a sleeve that bridges a waist: its lower edge lies in the plane of symmetry, its upper edge on the body.
SleeveOptions options_of(const ContactReference& reference, int level) {
  SleeveOptions o;
  o.body = body_of(reference);
  o.material = material_of(reference.part(2));
  o.r0 = reference.header("R0");
  o.l0 = reference.header("half-length");
  o.to = reference.header("z");
  o.hold_top = "xyz";
  o.around = 24 << level;
  o.along = 12 << level;
  return o;
}

/// First row, from below, that touches the body; each row below the held end touches with all its nodes or with none.
int first_in_contact(const Sleeve& sleeve) {
  int first = -1;
  for (int j = 0; j < sleeve.along; ++j) {
    int touching = 0;
    for (int i = 0; i < sleeve.around; ++i) touching += sleeve.pressure(i, j) > 0.0 ? 1 : 0;
    EXPECT_EQ(touching, first >= 0 || touching > 0 ? sleeve.around : 0) << "row " << j;
    if (first < 0 && touching > 0) first = j;
  }
  return first;
}

/// Relative root mean square of the pressure's error from two elements beyond lift-off to an eighth below the end.
double pressure_error(const Sleeve& sleeve, const ContactReference& reference, int first) {
  double error = 0.0, scale = 0.0;
  for (int j = first + 2; j <= sleeve.along - sleeve.along / 8; ++j)
    for (int i = 0; i < sleeve.around; ++i) {
      const double exact = reference.at("z", sleeve.position(i, j).z(), "p");
      error += std::pow(sleeve.pressure(i, j) - exact, 2);
      scale += exact * exact;
    }
  return std::sqrt(error / scale);
}

class SleeveOnWaist : public testing::TestWithParam<std::string> {};

// A sleeve lifts off a waist within one element of the reference; the bridge has its radius, and the pressure beyond
// two elements from lift-off is within 0.1 %. Where it hovers, the pressure is zero.
TEST_P(SleeveOnWaist, LiftsOffAndKeepsItsPressure) {
  const ContactReference reference("contact_waist_" + GetParam());
  const double lift_off = reference.header("z_d");
  std::array<double, 3> radius_error{}, error{};
  for (int level = 0; level < 3; ++level) {
    const Sleeve sleeve = settle(options_of(reference, level));
    expect_balanced(sleeve);
    const int first = first_in_contact(sleeve);
    ASSERT_GT(first, 0);
    const double above = sleeve.position(0, first).z(), below = sleeve.position(0, first - 1).z();
    EXPECT_LE(std::abs(above - lift_off), above - below);
    EXPECT_GT(sleeve.fields.gap[sleeve.node(0, 0)], 0.1);
    const double radius = sleeve.position(0, 0).head<2>().norm();
    radius_error[level] = std::abs(radius / reference.header("r_mid") - 1.0);
    error[level] = pressure_error(sleeve, reference, first);
    print("waist_%-7s %3d x %2d  lifts off at %.2f-%.2f (%.2f) mm  mid radius %.4f (%.4f) mm  pressure error %.4f %%\n",
          GetParam().c_str(), sleeve.around, sleeve.along, below, above, lift_off, radius, reference.header("r_mid"),
          100.0 * error[level]);
  }
  EXPECT_LE(radius_error.back(), 1e-4);
  EXPECT_LE(error.back(), 0.001);
  // Second order over the study; from one mesh to the next the row of lift-off jumps.
  EXPECT_GE(0.5 * std::log2(error.front() / error.back()), 1.9);
}

INSTANTIATE_TEST_SUITE_P(Contact, SleeveOnWaist, testing::Values("nh", "rebar", "itskov"));

// Ten times more or less augmentation changes no nodal pressure by 0.1 %, also where contact opens.
TEST(PenaltyNumber, DoesNotEnterLiftOff) {
  SleeveOptions o = options_of(ContactReference("contact_waist_rebar"), 1);
  const Sleeve usual = settle(o);
  for (const double factor : {0.1, 10.0}) {
    o.contact.relative_stiffness = factor * SleeveContact().relative_stiffness;
    const Sleeve other = settle(o);
    for (int j = 0; j < o.along; ++j)
      for (int i = 0; i < o.around; ++i)
        EXPECT_NEAR(other.pressure(i, j), usual.pressure(i, j), 1e-3 * usual.pressure(i, j));
  }
}

}  // namespace
}  // namespace toile::test
