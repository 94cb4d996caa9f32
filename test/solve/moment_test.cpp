// Shells that are loaded by moments alone.
#include <gmock/gmock.h>

#include <cmath>

#include "panels.hpp"
#include "recorded.hpp"
#include "stages.hpp"
#include "toile/material/relaxed_response.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double shear_modulus = 0.01;  // MPa, of transverse shear

Panels flat_shell() {
  Panels sheet(neo_hookean());
  sheet.add(solve::Vec3::Zero(), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
  sheet.make_shells(shear_modulus);
  return sheet;
}

/// Moment about y along a side, i = 0 or i = across, N mm per mm.
solve::NodalLoad edge_moment(int i, double value) {
  solve::NodalLoad load{"moment", {}, {}, {0.0, value, 0.0}, true};
  for (int j = 0; j <= Panels::along; ++j) {
    load.nodes.push_back(Panels::node(0, i, j));
    load.share.push_back(Panels::size * (j == 0 || j == Panels::along ? 0.5 : 1.0));
  }
  return load;
}

/// Angle of a node's director from z towards x.
double angle(const solve::State& state, int node) {
  return std::atan2(state.frame[node](2, 0), state.frame[node](2, 2));
}

// Opposite moments bend a free strip, which is in equilibrium although nothing holds it: its ends turn against each
// other by an angle between that of a beam and that of a plate (h = 1 mm, E = 6 C10, nu = 1/2).
TEST(Moment, FreeStripInEquilibrium) {
  Panels strip = flat_shell();
  const double value = 1e-4, stiffness = 6.0 * 8.4667e-3 / 12.0,
               beam = value * Panels::size * Panels::across / stiffness;
  strip.problem.loads = {edge_moment(0, -value), edge_moment(Panels::across, value)};
  Recorded run(strip.problem);
  run.simulation.run(stage("load"));
  EXPECT_EQ(run.simulation.notes().size(), 6u);
  EXPECT_THAT(run.simulation.warnings(), IsEmpty());
  EXPECT_LT(run.last().balance.sum().norm(), 1e-6 * run.last().balance.magnitude);
  const solve::State& state = run.simulation.state();
  const double turned = angle(state, Panels::node(0, Panels::across, 2)) - angle(state, Panels::node(0, 0, 2));
  EXPECT_GT(turned, 0.75 * beam);
  EXPECT_LT(turned, 1.02 * beam);
}

// A moment that turns a free strip has no equilibrium.
TEST(Moment, FreeStripThatTurns) {
  Panels strip = flat_shell();
  strip.problem.loads = {edge_moment(0, 1e-4)};
  Recorded run(strip.problem);
  EXPECT_THAT(failure_of(run.simulation, stage("load")),
              AllOf(HasSubstr("there is no equilibrium"), HasSubstr("rotation about the axis")));
}

// A sheet whose positions are all held turns its directors only: a moment m per area balances the transverse shear
// G h sin w cos w of directors that have turned by w.
TEST(Moment, DirectorsOfHeldPositions) {
  for (const bool damped : {false, true}) {
    Panels sheet = flat_shell();
    const double m = 0.05 * shear_modulus;
    solve::NodalLoad load{"moment", {}, {}, {0.0, m, 0.0}, true};
    for (int j = 0; j <= Panels::along; ++j)
      for (int i = 0; i <= Panels::across; ++i) {
        load.nodes.push_back(Panels::node(0, i, j));
        load.share.push_back(Panels::size * Panels::size * (i == 0 || i == Panels::across ? 0.5 : 1.0) *
                             (j == 0 || j == Panels::along ? 0.5 : 1.0));
      }
    sheet.hold_nodes(load.nodes, {true, true, true});
    sheet.problem.loads = {load};
    Recorded run(sheet.problem);
    solve::StageOptions turn = stage("load");
    turn.damping.active = damped;
    run.simulation.run(turn);
    EXPECT_EQ(run.last().negative_pivots, 0);
    EXPECT_LT(run.last().accuracy.residual, 1e-10);
    for (const int node : load.nodes)
      EXPECT_NEAR(angle(run.simulation.state(), node), 0.5 * std::asin(2.0 * m / shear_modulus), 1e-8) << node;
  }
}

// A clamped strip whose fibres carry no compression, of modulus Y and without Poisson contraction, under a tension N at
// the eccentricity e = M/N > h/6: only the depth c = 3 (h/2 - e) carries, and the curvature is 2 N/(Y c^2), not the
// 12 M/(Y h^3) of the whole section. (Seven layers integrate the kink to 0.4 %.)
TEST(Moment, OnlyStretchedFibresBend) {
  constexpr double young = 0.1, tension = 1e-8, e = 0.25, c = 3.0 * (0.5 - e);
  const material::LawV1& law = *material::find("isotropic-elastic");
  for (const bool slack : {true, false}) {
    const auto response = std::make_shared<material::RelaxedResponse>(law, material::Relaxation::slack_fibres, 1e-4);
    Panels strip(
        std::make_shared<material::Material>(law, std::vector<double>{young, 0.0}, 1.0, slack ? response : nullptr));
    strip.add(solve::Vec3::Zero(), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
    strip.make_shells(young);
    strip.problem.models[0].shell.layers = 7;
    solve::NodalLoad pull = edge_moment(Panels::across, 0.0), bend = edge_moment(Panels::across, e * tension);
    pull.moment = false;
    pull.value = tension * solve::Vec3::UnitX();
    strip.problem.loads = {pull, bend};
    strip.hold_nodes(edge_moment(0, 0.0).nodes, {true, false, true});
    strip.problem.supports.back().director = solve::DirectorSupport::held;
    strip.hold_nodes({0}, {false, true, false});
    Recorded run(strip.problem);
    run.simulation.run(stage("load"));
    const double curvature =
        angle(run.simulation.state(), Panels::node(0, Panels::across, 2)) / (Panels::size * Panels::across);
    const double expected = (slack ? 2.0 / (c * c) : 12.0 * e) * tension / young;
    EXPECT_NEAR(curvature, expected, 0.01 * expected) << slack;
    EXPECT_THAT(run.simulation.warnings(), IsEmpty());
  }
}

}  // namespace
}  // namespace toile::test
