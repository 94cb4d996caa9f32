// The shipped scenes of the pantyhose leg on a coarse mesh.
#include <gtest/gtest.h>

#include "leg_scene.hpp"

namespace toile::test {
namespace {

enum { B, B1, C, D, F, G };

/// What every leg must keep, whatever its fabric.
void expect_sound(const Leg& leg) {
  EXPECT_EQ(leg.state.seam, 1.0);
  EXPECT_TRUE(leg.report.undamped);
  EXPECT_EQ(leg.report.negative_pivots, 0);
  EXPECT_LE(leg.imbalance(), 1e-10);
  EXPECT_LE(leg.report.accuracy.gap, 1e-12);
}

void expect_decreasing(const std::vector<LegLevel>& level) {
  EXPECT_GT(level[B].pressure, level[C].pressure);
  EXPECT_GT(level[C].pressure, level[F].pressure);
  EXPECT_GT(level[F].pressure, level[G].pressure);
}

/// Stretch of nine tenths of the elements, as doc/pantyhose-leg.md has it.
void expect_stretch(const Leg& leg, const std::string& field, double low, double high) {
  EXPECT_NEAR(leg.quantile(field, 0.05), low, 0.02) << field;
  EXPECT_NEAR(leg.quantile(field, 0.95), high, 0.02) << field;
}

// The shipped pantyhose leg presses as the published fabric must: less from ankle to thigh, by Laplace's law where the
// leg is nearly a cylinder, and in tension everywhere.
TEST(PantyhoseLeg, Rebar) {
  const Leg leg = run_leg("pantyhose-leg.xml");
  expect_sound(leg);
  const std::vector<LegLevel> level = leg.levels();
  expect_decreasing(level);
  EXPECT_NEAR(level[B].pressure, 0.97, 0.05);
  EXPECT_NEAR(level[C].pressure, 0.43, 0.03);
  EXPECT_NEAR(level[G].pressure, 0.23, 0.03);
  for (const int l : {B, B1, D, F, G}) EXPECT_NEAR(level[l].pressure, level[l].laplace, 0.05 * level[l].laplace) << l;
  EXPECT_GT(level[C].pressure, level[C].laplace) << "the calf is convex along the leg too";
  EXPECT_GT(leg.fields.smallest_principal_stress, -1e-9);
  // Without friction the fabric shares its tension along the leg, so its wale stretch is uneven.
  expect_stretch(leg, "stretch_wale", 1.01, 1.36);
  expect_stretch(leg, "stretch_course", 1.65, 1.96);
}

// Fabric that keeps its height has the pattern's stretch, 2 by 1.15, and the pressures that this stretch means.
TEST(PantyhoseLeg, Held) {
  const Leg leg = run_leg("pantyhose-leg-held.xml");
  expect_sound(leg);
  const std::vector<LegLevel> level = leg.levels();
  expect_stretch(leg, "stretch_wale", 1.14, 1.18);
  expect_stretch(leg, "stretch_course", 1.98, 2.02);
  EXPECT_NEAR(level[B].pressure, 0.9, 0.06);
  EXPECT_NEAR(level[C].pressure, 0.55, 0.06);
  EXPECT_NEAR(level[G].pressure, 0.35, 0.03);
}

// The Itskov model of the same fabric reaches its end and presses harder than the rebar model everywhere.
TEST(PantyhoseLeg, Itskov) {
  const Leg leg = run_leg("pantyhose-leg-itskov.xml");
  expect_sound(leg);
  const std::vector<LegLevel> level = leg.levels();
  expect_decreasing(level);
  EXPECT_GT(level[B].pressure, 1.2);
  EXPECT_GT(level[G].pressure, 0.35);
}

// The stiff wale law along the course too multiplies the pressure at the ankle.
TEST(PantyhoseLeg, Isotropic) {
  const Leg leg = run_leg("pantyhose-leg-isotropic.xml");
  expect_sound(leg);
  EXPECT_GT(leg.levels()[B].pressure, 3.0);
}

// A fabric that is stiffer at the ankle and softer at the thigh presses more at the ankle and less at the thigh.
TEST(PantyhoseLeg, Graduated) {
  const Leg leg = run_leg("pantyhose-leg-graduated.xml");
  expect_sound(leg);
  const std::vector<LegLevel> level = leg.levels();
  expect_decreasing(level);
  EXPECT_GT(level[B].pressure, 1.3);
  EXPECT_LT(level[G].pressure, 0.18);
}

// One panel closed on itself presses like two panels of half the width, away from the ends.
TEST(PantyhoseLeg, OnePanel) {
  const Leg one = run_leg("pantyhose-leg-one-panel.xml");
  expect_sound(one);
  const std::vector<LegLevel> level = one.levels();
  const std::vector<LegLevel> two = run_leg("pantyhose-leg.xml").levels();
  for (const int l : {B1, C, D, F}) EXPECT_NEAR(level[l].pressure, two[l].pressure, 0.04 * two[l].pressure) << l;
}

// The settled state does not depend on the way to it: sewing from open seams ends where a start with closed seams does.
TEST(PantyhoseLeg, PathIndependence) {
  const std::string closed_start =
      both_panels(
          "<ParameterList name=\"Placement\"><Parameter name=\"coverage\" type=\"double\" value=\"0.5\"/>"
          "</ParameterList>") +
      "<ParameterList name=\"Stages\"><Parameter name=\"replace\" type=\"bool\" value=\"true\"/>"
      "<ParameterList name=\"settle\"><Parameter name=\"type\" type=\"string\" value=\"settle\"/>"
      "<ParameterList name=\"Damping\"/></ParameterList></ParameterList>";
  const Leg sewn = run_leg("pantyhose-leg.xml");
  const Leg started = run_leg("pantyhose-leg.xml", closed_start);
  expect_sound(started);
  double largest = 0.0;
  for (size_t n = 0; n < sewn.fields.pressure.size(); ++n) {
    largest = std::max(largest, sewn.fields.pressure[n]);
    EXPECT_NEAR(started.fields.pressure[n], sewn.fields.pressure[n], 1e-6 * sewn.fields.pressure[n]) << "node " << n;
  }
  EXPECT_GT(largest, 5e-4);
  EXPECT_NEAR(started.report.energy.strain, sewn.report.energy.strain, 1e-6 * sewn.report.energy.strain);
}

// The same pattern runs on the leg of a body of a real shape, with lift-off where the body is hollow.
TEST(PantyhoseLeg, RealLeg) {
  const Leg leg = run_leg("pantyhose-real-leg.xml");
  expect_sound(leg);
  const std::vector<LegLevel> level = leg.levels();
  expect_decreasing(level);
  EXPECT_NEAR(level[B].pressure, 0.97, 0.1);
  EXPECT_NEAR(level[C].pressure, 0.43, 0.06);
  int lifted = 0, bridged = 0;
  for (size_t n = 0; n < leg.fields.pressure.size(); ++n) {
    EXPECT_GE(leg.fields.pressure[n], 0.0) << "node " << n;
    if (leg.fields.gap[n] <= 1e-3) continue;
    const bool bridges = leg.fields.pressure[n] > 0.0;
    ++(bridges ? bridged : lifted);
    // The tilt of facets lifts a node among pressed ones, by less than the chords of this coarse mesh sag: it has the
    // pressure of its tension.
    if (bridges) {
      EXPECT_LT(leg.fields.gap[n], 0.5) << "node " << n;
    }
  }
  EXPECT_LE(bridged, 3);
  EXPECT_GT(lifted, 10);
}

}  // namespace
}  // namespace toile::test
