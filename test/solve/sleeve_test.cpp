// Stages of a sleeve on a rigid cylinder, on one and on several ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "stages.hpp"
#include "toile/base/error.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::test {
namespace {

// The pressure of a sleeve held at an axial stretch of 1.1 converges with second order to T/R
// (test/data/contact/contact_cyl_ax1.1_nh.csv).
TEST(Sleeve, PressureConvergesToLaplaceWithSecondOrder) {
  const double exact = 1.8517249566370777e-4;
  std::vector<double> errors;
  for (const int n : {1, 2, 4}) {
    Sleeve sleeve(options(12 * n, 6 * n), neo_hookean());
    sleeve.problem.contact.offset_by_half_thickness = false;
    solve::Simulation simulation(sleeve.problem, {});
    simulation.set_start(closed_start(sleeve.problem));
    simulation.run(stage("settle"));
    errors.push_back(std::abs(mid_pressure(sleeve, simulation.state(), 12 * n, 6 * n) / exact - 1.0));
  }
  EXPECT_LT(errors.back(), 4e-3);
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.9);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 1.9);
}

// Unstressed fabric 1.5 mm off the body does not press it: the forces of its rounded positions pull no node onto it,
// and the start is the equilibrium.
TEST(Sleeve, RoundOffIsNoForce) {
  Sleeve::Options at_rest = options();
  at_rest.radius = 61.5;
  at_rest.axial = 1.0;
  const double half = std::acos(-1.0) / at_rest.around;
  at_rest.r0 = at_rest.radius * std::sin(half) / half;  // as long as the chords
  Sleeve sleeve(at_rest, neo_hookean());
  const Cylinder body(60.0);
  sleeve.problem.surface = &body;
  solve::Simulation simulation(sleeve.problem, {});
  const solve::State start = closed_start(sleeve.problem);
  simulation.set_start(start);
  simulation.run(stage("settle"));
  const solve::State& end = simulation.state();
  for (size_t c = 0; c < start.position.size(); ++c) {
    EXPECT_EQ(end.contact_force[c], 0.0) << c;
    EXPECT_LT((end.position[c] - start.position[c]).norm(), 1e-10) << c;
  }
}

// The contact stiffness steers the iteration and does not enter the result.
TEST(Sleeve, PressureDoesNotDependOnTheContactStiffness) {
  std::vector<double> pressure;
  for (const double stiffness : {0.1, 1.0, 10.0}) {
    Sleeve sleeve(options(), neo_hookean());
    sleeve.problem.contact.relative_stiffness = stiffness;
    solve::Simulation simulation(sleeve.problem, {});
    simulation.set_start(closed_start(sleeve.problem));
    simulation.run(stage("settle"));
    pressure.push_back(mid_pressure(sleeve, simulation.state(), 24, 8));
  }
  EXPECT_NEAR(pressure[0] / pressure[1], 1.0, 1e-8);
  EXPECT_NEAR(pressure[2] / pressure[1], 1.0, 1e-8);
}

// Sewing an open seam by continuation ends in the state that a closed start settles to: hyperelastic fabric without
// friction has no memory.
TEST(Sleeve, SewingReachesTheStateOfTheClosedStart) {
  Sleeve closed(options(), neo_hookean());
  solve::Simulation direct(closed.problem, {});
  direct.set_start(closed_start(closed.problem));
  direct.run(stage("settle"));

  Sleeve open(options(), neo_hookean());
  open_up(open, options(), 60.0);
  solve::Simulation sewn(open.problem, {});
  int steps = 0;
  bool undamped_at_end = false;
  double damped_share = 0.0, last_share = 1.0;
  double largest_gap = 0.0;
  sewn.observe([&](const solve::StepReport& r, const solve::State&) {
    ++steps;
    undamped_at_end = r.undamped && r.balance.damping.norm() == 0.0;
    largest_gap = r.accuracy.gap;
    damped_share = std::max(damped_share, r.accuracy.undamped_residual);
    last_share = r.accuracy.undamped_residual;
  });
  solve::StageOptions sew = stage("sew");
  sew.damping.active = true;
  sewn.run(sew);
  EXPECT_GT(steps, 2);
  EXPECT_TRUE(undamped_at_end);
  EXPECT_LT(largest_gap, 1e-12);
  EXPECT_GT(damped_share, 1e-9);  // while it sews, the damping carries a part
  EXPECT_LT(last_share, 1e-10);
  EXPECT_DOUBLE_EQ(sewn.state().seam, 1.0);
  const double expected = mid_pressure(closed, direct.state(), 24, 8);
  EXPECT_NEAR(mid_pressure(open, sewn.state(), 24, 8) / expected, 1.0, 1e-8);
}

// Forces of body, supports, loads, damping and pins add up to zero, also with the contact force taken from the written
// pressure.
TEST(Sleeve, ForcesOfTheWrittenFieldsBalance) {
  Sleeve sleeve(options(), neo_hookean());
  solve::Simulation simulation(sleeve.problem, {});
  solve::StepReport last;
  simulation.observe([&](const solve::StepReport& r, const solve::State&) { last = r; });
  simulation.set_start(closed_start(sleeve.problem));
  simulation.run(stage("settle"));
  solve::ForceBalance balance = last.balance;
  EXPECT_GT(balance.magnitude, 1.0);
  EXPECT_LT(balance.sum().norm(), 1e-6 * balance.magnitude);
  balance.contact = contact_resultant(compute_fields(sleeve.problem, simulation.state()));
  EXPECT_LT(balance.sum().norm(), 1e-6 * balance.magnitude);
  // Reactions of the two held ends are opposite: the axial force of contact_cyl_ax1.1_nh.csv, 3.076 N.
  EXPECT_NEAR(balance.support[1][2], 3.076, 0.02);
}

// A stage that cannot reach its end throws SolveError, says how far it came, and keeps the last converged state.
TEST(Sleeve, AStageThatCannotEndKeepsTheLastConvergedState) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  sleeve.problem.supports[1].displacement = solve::Vec3(0.0, 0.0, 30.0);
  solve::Simulation simulation(sleeve.problem, {});
  double reached = 0.0;
  simulation.observe([&](const solve::StepReport& r, const solve::State&) { reached = r.load; });
  simulation.set_start(closed_start(sleeve.problem));
  solve::StageOptions pull = stage("load");
  pull.max_steps = 3;
  pull.first_step = pull.largest_step = 0.1;
  try {
    simulation.run(pull);
    FAIL() << "three steps of a tenth cannot reach the end";
  } catch (const base::SolveError& error) {
    EXPECT_NE(std::string(error.what()).find("could not reach its end"), std::string::npos) << error.what();
    EXPECT_EQ(error.code(), base::ExitCode::solve_failed);
  }
  EXPECT_GT(reached, 0.0);
  EXPECT_DOUBLE_EQ(simulation.state().load, reached);
}

// The last of the allowed steps may be the one that reaches the end.
TEST(Sleeve, TheLastAllowedStepMayReachTheEnd) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  sleeve.problem.supports[1].displacement = solve::Vec3(0.0, 0.0, 10.0);
  solve::Simulation simulation(sleeve.problem, {});
  simulation.set_start(closed_start(sleeve.problem));
  solve::StageOptions pull = stage("load");
  pull.max_steps = 2;
  pull.first_step = pull.largest_step = 0.5;
  simulation.run(pull);
  EXPECT_DOUBLE_EQ(simulation.state().load, 1.0);
}

// Elements outside the calibrated range are counted over all ranks.
TEST(Sleeve, ExtrapolatedElementsOfEveryRankAreCounted) {
  Sleeve sleeve(options(12, 6), pantyhose());
  sleeve.problem.supports[1].displacement = solve::Vec3(0.0, 0.0, 200.0);
  solve::Simulation simulation(sleeve.problem, {});
  int extrapolated = 0;
  simulation.observe([&](const solve::StepReport& r, const solve::State&) { extrapolated = r.extrapolated; });
  simulation.set_start(closed_start(sleeve.problem));
  simulation.run(stage("load"));
  EXPECT_EQ(extrapolated, 12 * 6);
}

// A node that its support keeps from moving along the body's normal is carried by the support, not by contact.
TEST(Sleeve, EndsHeldAcrossTheBodyAreCarriedByTheirSupports) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  for (solve::Support& end : sleeve.problem.supports) end.held = {true, true, false};
  solve::Simulation simulation(sleeve.problem, {});
  simulation.set_start(closed_start(sleeve.problem));
  simulation.run(stage("settle"));
  const solve::Fields fields = compute_fields(sleeve.problem, simulation.state());
  EXPECT_LT(fields.gap[0], -0.1);  // the inner face of an end lies in the body, and stays there
  EXPECT_EQ(fields.pressure[0], 0.0);
  EXPECT_GT(mid_pressure(sleeve, simulation.state(), 12, 6), 0.0);
}

// A step that does not converge is cut back, and the stage still reaches its end.
TEST(Sleeve, AFailedStepIsCutBack) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  sleeve.problem.supports[1].displacement = solve::Vec3(0.0, 0.0, 150.0);
  solve::SolverOptions few;
  few.newton.max_iterations = 3;
  solve::Simulation simulation(sleeve.problem, few);
  simulation.set_start(closed_start(sleeve.problem));
  solve::Simulation unhurried(sleeve.problem, {});
  unhurried.set_start(closed_start(sleeve.problem));
  unhurried.run(stage("settle"));
  simulation.set_state(unhurried.state());
  solve::StageOptions pull = stage("load");
  pull.first_step = pull.largest_step = 1.0;
  simulation.run(pull);
  EXPECT_GT(simulation.statistics().cut_backs, 0);
  EXPECT_DOUBLE_EQ(simulation.state().load, 1.0);
}

// Where Newton alone does not find the settled state, damped steps at fixed load lead to it, and the final state is the
// undamped one.
TEST(Sleeve, DampedStepsReachAStateThatNewtonAloneDoesNot) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  solve::Simulation direct(sleeve.problem, {});
  direct.set_start(closed_start(sleeve.problem));
  direct.run(stage("settle"));
  solve::SolverOptions few;
  few.newton.max_iterations = 2;
  few.newton.tolerance = 1e-6;
  solve::StageOptions settle = stage("settle");
  solve::State rough = closed_start(sleeve.problem);  // rows crowded towards one end
  for (solve::Vec3& p : rough.position) p[2] += 12.0 * std::sin(std::acos(-1.0) * p[2] / 110.0);
  solve::Simulation undamped(sleeve.problem, few);
  undamped.set_start(rough);
  EXPECT_THROW(undamped.run(settle), base::SolveError);
  settle.damping.active = true;
  solve::Simulation damped(sleeve.problem, few);
  damped.set_start(rough);
  damped.run(settle);
  EXPECT_NEAR(mid_pressure(sleeve, damped.state(), 12, 6) / mid_pressure(sleeve, direct.state(), 12, 6), 1.0, 1e-4);
}

// A frictionless sleeve on a body of revolution can spin: the motion is found, named and held.
TEST(Sleeve, NullMotionIsNamed) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  solve::Simulation simulation(sleeve.problem, {});
  simulation.set_start(closed_start(sleeve.problem));
  simulation.run(stage("settle"));
  ASSERT_EQ(simulation.notes().size(), 1u);
  EXPECT_NE(simulation.notes()[0].find("rotation about the axis (0, 0, 1)"), std::string::npos)
      << simulation.notes()[0];
}

}  // namespace
}  // namespace toile::test
