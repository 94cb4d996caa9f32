// A run that goes on from a checkpoint.
#include "toile/solve/checkpoint.hpp"

#include <gmock/gmock.h>

#include "panels.hpp"
#include "recorded.hpp"
#include "slack_panel.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

using solve::StageOptions;
using ::testing::HasSubstr;

/// What is left of a run at its end, without its times.
solve::CheckpointArrays figures(const solve::Simulation& simulation) {
  solve::Checkpoint end = simulation.checkpoint();
  end.seconds = 0.0;
  for (solve::StepReport& report : end.reports) report.seconds = 0.0;
  return to_arrays(end);
}

void expect_same(const solve::CheckpointArrays& a, const solve::CheckpointArrays& b) {
  EXPECT_EQ(a.reals, b.reals);
  EXPECT_EQ(a.integers, b.integers);
  EXPECT_EQ(a.texts, b.texts);
}

/// Runs the stages, and again from each accepted step; expects the same bits at the end. Returns the number of steps.
int run_from_each_step(const solve::Problem& problem, const solve::State& start,
                       const std::vector<StageOptions>& stages) {
  solve::Simulation whole(problem, {});
  std::vector<solve::CheckpointArrays> checkpoints;
  whole.observe(
      [&](const solve::StepReport&, const solve::State&) { checkpoints.push_back(to_arrays(whole.checkpoint())); });
  whole.set_start(start);
  for (const StageOptions& stage : stages) whole.run(stage);
  const solve::CheckpointArrays end = figures(whole);
  for (size_t i = 0; i < checkpoints.size(); ++i) {
    SCOPED_TRACE("after step " + std::to_string(i + 1));
    solve::Simulation rest(problem, {});
    rest.resume(solve::from_arrays(checkpoints[i]));
    for (const StageOptions& stage : stages) rest.run(stage);
    expect_same(figures(rest), end);
    if (testing::Test::HasFailure()) break;
  }
  return static_cast<int>(checkpoints.size());
}

StageOptions named(const char* name, StageOptions stage) {
  stage.name = name;
  return stage;
}

// A damped sewing onto the body, a pull along it and a rest without a support that is released end with the same bits,
// from whichever step they go on.
TEST(Checkpoint, SewingPullingAndReleasingGoOnWithTheSameBits) {
  const Sleeve::Options o = options(10, 4);
  Sleeve sleeve(o, pantyhose());
  open_up(sleeve, o, 63.0);
  sleeve.problem.supports[1].displacement = solve::Vec3(0.0, 0.0, 5.0);
  StageOptions sew = stage("sew"), pull = stage("load"), rest = stage("settle");
  sew.damping.active = true;
  pull.first_step = pull.largest_step = 0.4;
  pull.stability_every_step = true;
  rest.released = {"top"};
  rest.damping.active = true;
  EXPECT_GT(run_from_each_step(sleeve.problem, placed_state(sleeve.problem),
                               {named("sew", sew), named("pull", pull), named("rest", rest)}),
            8);
}

/// A shell that is clamped at two sides, one of which moves.
Panels bent_panel() {
  Panels panel(neo_hookean());
  panel.add(solve::Vec3::Zero(), solve::Vec3(1.1, 0.0, 0.0), solve::Vec3(0.0, 1.05, 0.0), 0);
  panel.make_shells(0.01);
  panel.hold(0, 0);
  panel.hold(0, Panels::across);
  for (solve::Support& support : panel.problem.supports) support.director = solve::DirectorSupport::held;
  return panel;
}

// Shells that turn far, whose thickness is frozen in each step, go on with the same bits: step by step in the load, and
// along the arc to the load and to a displacement.
TEST(Checkpoint, ShellsGoOnWithTheSameBits) {
  Panels panel = bent_panel();
  panel.problem.supports[1].turn = solve::Turn{solve::Vec3(0.0, 20.0, 0.0), solve::Vec3::UnitX(), 0.6};
  StageOptions turn = stage("load"), arc = turn, until = turn;
  turn.target = 0.5;
  arc.arc_length = arc.stability_every_step = true;
  arc.first_step = 0.3;
  until.arc_length = true;
  until.until = solve::PathTarget{false, "node", Panels::node(0, Panels::across, 0), -1, 2, -3.0};
  const StageOptions rest = named("rest", stage("settle"));
  EXPECT_GT(run_from_each_step(panel.problem, placed_state(panel.problem),
                               {rest, named("until", until), named("turn", turn), named("arc", arc)}),
            10);
}

// Slack fabric that is drawn aside, pulled taut along a diagonal and let go goes on with the same bits: each step
// starts from where the fabric lay, and the final state is found from itself.
TEST(Checkpoint, FabricThatWrinklesGoesOnWithTheSameBits) {
  Panels panels = slack_panel();
  panels.problem.supports[1].displacement = {3.0, 4.0, 2.0};
  StageOptions pull = stage("load"), rest = stage("settle");
  pull.first_step = pull.largest_step = 0.25;
  rest.released = {panels.problem.supports[1].name};
  EXPECT_GT(
      run_from_each_step(panels.problem, placed_state(panels.problem), {named("pull", pull), named("rest", rest)}), 4);
}

// A checkpoint is refused for another garment, and for another stage.
TEST(Checkpoint, IsRefusedWhereItDoesNotBelong) {
  Sleeve sleeve(options(10, 4), neo_hookean()), other(options(8, 4), neo_hookean());
  solve::Simulation first(sleeve.problem, {});
  solve::Checkpoint half;
  first.observe([&](const solve::StepReport& r, const solve::State&) {
    if (!r.undamped) half = first.checkpoint();
  });
  first.set_start(closed_start(sleeve.problem));
  first.run(named("pull", stage("load")));
  solve::Simulation of_other(other.problem, {}), of_same(sleeve.problem, {});
  const auto error_of = [](const auto& work) -> std::string {
    try {
      work();
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of([&] { of_other.resume(half); }), HasSubstr("of another garment"));
  of_same.resume(half);
  EXPECT_THAT(error_of([&] { of_same.run(named("settle", stage("settle"))); }),
              HasSubstr("of stage \"pull\", which is \"settle\" here"));
  solve::CheckpointArrays arrays = to_arrays(half);
  arrays.reals.at("equilibrium: z").pop_back();
  EXPECT_THAT(error_of([&] { solve::from_arrays(arrays); }), HasSubstr("not complete"));
}

}  // namespace
}  // namespace toile::test
