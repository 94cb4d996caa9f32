// Supports that turn about an axis.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "panels.hpp"
#include "recorded.hpp"
#include "stages.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::test {
namespace {

using solve::Vec3;

constexpr double degree = M_PI / 180.0;

/// A stretched panel between its sides "support0" (i = 0) and "support1" (i = across), clamped if it is a shell.
Panels stretched_panel(const char* formulation) {
  Panels panel(neo_hookean());
  panel.add(Vec3::Zero(), 1.1 * Vec3::UnitX(), 1.05 * Vec3::UnitY(), 0);
  panel.mesh.normal.assign(static_cast<size_t>(Panels::nodes()), Vec3::UnitZ());
  panel.problem.models[0] = {element::find(formulation), panel.material.get(), {3, 0.01, false}};
  panel.hold(0, 0);
  panel.hold(0, Panels::across);
  const int ranks = Tpetra::getDefaultComm()->getSize();
  const auto rank_of_row = [ranks](int j) { return std::min(j, Panels::along - 1) * ranks / Panels::along; };
  for (int n = 0; n < Panels::nodes(); ++n)
    panel.problem.cluster_rank[static_cast<size_t>(n)] = rank_of_row(n / (Panels::across + 1));
  for (int e = 0; e < Panels::across * Panels::along; ++e)
    panel.problem.element_rank[0][static_cast<size_t>(e)] = rank_of_row(e / Panels::across);
  if (panel.problem.models[0].is_shell())
    for (solve::Support& support : panel.problem.supports) support.director = solve::DirectorSupport::held;
  return panel;
}

solve::StageOptions load_stage(double target = 1.0, double step = 0.2) {
  solve::StageOptions s = stage("load");
  s.target = target;
  s.first_step = s.largest_step = step;
  return s;
}

solve::SolverOptions direct() {
  solve::SolverOptions solver;
  solver.linear.method = "direct";  // small problems, of several ranks, spend their time on messages
  return solver;
}

/// Settles first, so that the thickness of shells is that of the stretched panel.
struct Turned : Recorded {
  Turned(const solve::Problem& problem, const std::vector<solve::StageOptions>& stages) : Recorded(problem, direct()) {
    simulation.run(stage("settle"));
    for (const solve::StageOptions& s : stages) simulation.run(s);
  }
};

class Turning : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formulations, Turning, testing::Values("membrane4", "shell4", "shell4r"));

// A panel whose two sides turn together about a skew axis, by more than half a turn, and are moved as well, goes along
// as a rigid body: at every step its nodes lie on their circles, and neither its energy nor its directors' bending
// changes.
TEST_P(Turning, TakesAPanelAlongAsARigidBody) {
  Panels panel = stretched_panel(GetParam());
  const solve::Turn turn{Vec3(5.0, -20.0, 8.0), Vec3(1.0, 2.0, 2.0) / 3.0, 200.0 * degree};
  const Vec3 move(3.0, -4.0, 5.0);
  for (solve::Support& support : panel.problem.supports) {
    support.turn = turn;
    support.displacement = move;
  }
  const Turned r(panel.problem, {load_stage(1.0, 0.05)});
  ASSERT_GT(r.reports.size(), 20u);
  ASSERT_GT(r.reports[0].energy.strain, 0.0);
  for (size_t k = 0; k < r.reports.size(); ++k) {
    const double load = r.reports[k].load;
    const Eigen::AngleAxisd rotation(load * turn.angle, turn.axis);
    for (size_t n = 0; n < r.states[k].position.size(); ++n) {
      const Vec3 expected = turn.point + rotation * (r.states[0].position[n] - turn.point) + load * move;
      EXPECT_LT((r.states[k].position[n] - expected).norm(), 1e-7) << "node " << n << " at load " << load;
    }
    EXPECT_NEAR(r.reports[k].energy.strain, r.reports[0].energy.strain, 1e-9 * r.reports[0].energy.strain) << load;
    for (size_t s = 0; s < 2; ++s)
      EXPECT_NEAR(r.reports[k].balance.torque[s], -r.reports[k].balance.torque[1 - s], 1e-8) << load;
  }
}

/// The sides of a panel, of which the second one is bent and twisted about an axis through its middle.
Panels bent_panel(const char* formulation) {
  Panels panel = stretched_panel(formulation);
  const Vec3 middle = panel.mesh.placed[Panels::node(0, Panels::across, Panels::along / 2)];
  panel.problem.supports[1].turn = solve::Turn{middle, Vec3(0.8, 0.6, 0.0), 30.0 * degree};
  return panel;
}

// The torques that two sides exert about one axis, the moments of their held directors included, add up to zero.
TEST_P(Turning, TorquesOfBothSidesBalance) {
  Panels panel = bent_panel(GetParam());
  panel.problem.supports[0].turn = panel.problem.supports[1].turn;
  panel.problem.supports[0].turn->angle = 0.0;
  const Turned r(panel.problem, {load_stage()});
  for (const solve::StepReport& report : r.reports) {
    EXPECT_NEAR(report.balance.torque[0], -report.balance.torque[1], 1e-8) << report.load;
  }
  EXPECT_GT(r.reports.back().balance.torque[1], 0.1);
}

// The torque is the derivative of the strain energy by the angle; a support that does not turn has none.
TEST(TurningTorque, IsTheDerivativeOfTheEnergy) {
  constexpr double h = 1e-3;
  Panels panel = bent_panel("membrane4");
  const Turned r(panel.problem, {load_stage(1.0 - h), load_stage(1.0, 1.0), load_stage(1.0 + h, 1.0)});
  std::vector<const solve::StepReport*> ends;
  for (const solve::StepReport& report : r.reports)
    if (report.undamped) ends.push_back(&report);
  ASSERT_EQ(ends.size(), 4u);  // the first one settles
  const double derivative =
      (ends[3]->energy.strain - ends[1]->energy.strain) / (2.0 * h * panel.problem.supports[1].turn->angle);
  EXPECT_GT(derivative, 0.1);
  EXPECT_NEAR(ends[2]->balance.torque[1], derivative, 1e-5 * derivative);
  EXPECT_EQ(ends[2]->balance.torque[0], 0.0);
}

// Arc length continuation, which needs the derivative of the held positions by the load, follows the same path.
TEST_P(Turning, ArcLengthFollowsTheSamePath) {
  Panels panel = stretched_panel(GetParam());
  panel.problem.supports[1].turn = solve::Turn{Vec3(0.0, 20.0, 0.0), Vec3::UnitX(), 30.0 * degree};
  solve::StageOptions arc = load_stage();
  const double natural = Turned(panel.problem, {arc}).reports.back().balance.torque[1];
  arc.arc_length = arc.stability_every_step = true;
  const Turned r(panel.problem, {arc});
  EXPECT_NEAR(r.reports.back().load, 1.0, 1e-12);
  EXPECT_GT(std::abs(natural), 0.1);
  EXPECT_NEAR(r.reports.back().balance.torque[1], natural, 1e-7 * std::abs(natural));
}

// A side that turns about itself leaves the panel flat if its directors are free (a hinge), and bends it if they are
// held.
TEST(TurningDirector, FollowsOnlyIfItIsHeld) {
  for (const bool is_held : {false, true}) {
    Panels panel = stretched_panel("shell4");
    solve::Support& side = panel.problem.supports[1];
    side.turn = solve::Turn{panel.mesh.placed[Panels::node(0, Panels::across, 0)], Vec3::UnitY(), 60.0 * degree};
    if (!is_held) side.director = solve::DirectorSupport::free;
    const Turned r(panel.problem, {load_stage()});
    const double added = r.reports.back().energy.strain - r.reports.front().energy.strain;
    const int node = Panels::node(0, Panels::across, 2);
    const Vec3 expected = is_held ? Vec3(std::sin(60.0 * degree), 0.0, std::cos(60.0 * degree)) : Vec3(0.0, 0.0, 1.0);
    EXPECT_LT((Vec3(r.states.back().frame[node].row(2)) - expected).norm(), 1e-9) << is_held;
    if (is_held) {
      EXPECT_GT(added, 1e-3);
      EXPECT_GT(r.reports.back().balance.torque[1], 1e-3);
    } else {
      EXPECT_NEAR(added, 0.0, 1e-9);
      EXPECT_NEAR(r.reports.back().balance.torque[1], 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace toile::test
