// What a stage says that fails: where it gave up, what did not converge there, and why.
#include "diagnosis/diagnosis.hpp"

#include <gmock/gmock.h>

#include "panels.hpp"
#include "recorded.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A stage without damping that failed to step on, on a sheet that is held at its left side and lies as it is placed.
struct Situation {
  Panels sheet{neo_hookean()};
  solve::StageOptions stage;
  solve::NewtonOptions newton;
  solve::State state;
  solve::Held held;
  solve::Remainder left;
  bool stepped = true, relaxing = false;

  explicit Situation(double stretch = 1.1) {
    sheet.add(solve::Vec3::Zero(), stretch * solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
    sheet.hold(0, 0);
    stage = test::stage("load");
    state = placed_state(sheet.problem);
    held = find_held(sheet.problem, state, {});
    left.force.assign(sheet.problem.clusters.size(), solve::Vec3::Zero());
    left.opening.assign(sheet.problem.clusters.size(), 0.0);
    left.total.force_scale = 1.0;
    left.state = state;
    left.iterations = 7;
    left.s = 0.25;
  }
  solve::Failure failure() const {
    return {sheet.problem, stage, newton, held, state, state, left, 0.125, stepped, relaxing, 1};
  }
};

// Forces that do not balance are told with residual, tolerance, and the worst node with its panel and place.
TEST(Diagnosis, NamesTheNodeWithTheLargestForce) {
  Situation s;
  const size_t worst = static_cast<size_t>(Panels::node(0, 2, 3));
  s.left.force[worst] = solve::Vec3(0.0, 3.0, 4.0);
  s.left.total.force = 0.5;
  EXPECT_EQ(solve::what_failed(s.failure()),
            "The last attempt, a step of 0.125, found no step that lowers the energy after 7 iterations. The forces do "
            "not balance: their residual is 0.5 of the nodal forces (tolerance 1e-10); worst at node 15 of panel "
            "\"panel0\", at (22, 30, 0) mm, in the pattern at (20, 30) mm, by 5 N.");
}

// A stage that was stopped is told where the garment has moved farthest, and how; not of less than a millimetre.
TEST(Diagnosis, NamesWhereAStoppedStageMoves) {
  Situation s;
  const size_t farthest = static_cast<size_t>(Panels::node(0, 2, 3));
  s.left.state.position[farthest] += solve::Vec3(0.0, 0.0, -0.5);
  EXPECT_THAT(solve::farthest_motion(s.failure()), IsEmpty());
  s.left.state.position[farthest] += solve::Vec3(0.0, 0.0, -4.5);
  EXPECT_EQ(
      solve::farthest_motion(s.failure()),
      "it was still moving, farthest at node 15 of panel \"panel0\", at (22, 30, -5) mm, in the pattern at "
      "(20, 30) mm, by 5 mm in the direction (0, 0, -1) since the start of the stage: look whether anything holds "
      "it there");
}

// A contact that does not close is told with its gap and the worst node, and balanced forces are not mentioned.
TEST(Diagnosis, NamesTheNodeWithTheLargestGap) {
  Situation s;
  s.left.opening[1] = s.left.total.gap = 0.25;
  const std::string text = solve::what_failed(s.failure());
  EXPECT_THAT(text,
              HasSubstr("Contact is violated by 0.25 mm (tolerance 1e-06 mm); worst at node 2 of panel \"panel0\""));
  EXPECT_THAT(text, Not(HasSubstr("forces")));
}

// An equilibrium that does not continue the path is no step: it is told as a jump.
TEST(Diagnosis, TellsAJump) {
  Situation s;
  EXPECT_EQ(
      solve::what_failed(s.failure()),
      "The last attempt, a step of 0.125, found an equilibrium on another branch, to which the garment would jump, "
      "and was given up.");
}

// A node on a seam is told with the name of the seam, or, where that is not known, with the nodes that it is sewn to.
TEST(Diagnosis, NamesTheSeam) {
  Situation s;
  s.sheet.problem.clusters[0] = {0, 3};
  s.left.total.gap = 1.0;
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr("mm, sewn to node 4 of panel \"panel0\"."));
  s.sheet.problem.seam.assign(s.sheet.problem.clusters.size(), "");
  s.sheet.problem.seam[0] = "side";
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr("mm, on the seam \"side\"."));
}

// How an attempt ended: out of iterations, or with a tangent that cannot be factorised; and what it was an attempt at.
TEST(Diagnosis, TellsHowTheAttemptEnded) {
  Situation s;
  s.left.total.force = 0.1;
  s.left.factorised = false;
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr("because its tangent could not be factorised."));
  s.left.iterations = s.newton.max_iterations;
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr("was given up after 60 iterations (\"most iterations\")."));
  s.stepped = false;
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr("The attempt at its start, before any step,"));
  s.relaxing = true;
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr("The last attempt at its undamped end"));
}

// The softest motion is told where it is free, next to free or unstable, with node and direction, and not where the
// garment resists it.
TEST(Diagnosis, NamesTheSoftestMotion) {
  Situation s;
  s.left.softest = {true, 1e-16, 5, solve::Vec3::UnitZ()};
  const std::string motion =
      " a motion that is largest at node 6 of panel \"panel0\", at (11, 10, 0) mm, in the pattern "
      "at (10, 10) mm, along (0, 0, 1).";
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr(" Nothing resists there" + motion));
  s.left.softest.stiffness = 2.5e-7;
  EXPECT_THAT(solve::what_failed(s.failure()),
              HasSubstr(" Little resists there (2.5e-07 of the mean stiffness)" + motion));
  s.left.softest.stiffness = -2.5e-7;
  EXPECT_THAT(solve::what_failed(s.failure()), HasSubstr(" The garment gives way there by" + motion));
  s.left.softest.stiffness = 1e-3;
  EXPECT_THAT(solve::what_failed(s.failure()), Not(HasSubstr("motion")));
}

// Fabric without an energy is told with the number of its points, the worst panel, element, place and stretches.
TEST(Diagnosis, NamesTheFabricWithoutEnergy) {
  Situation s(0.0);
  s.left.finite = false;
  EXPECT_THAT(
      solve::what_failed(s.failure()),
      AllOf(HasSubstr("came to a state that has no energy. The fabric has no energy at 48 of 48 points; worst in "
                      "panel \"panel0\", element 1, at (0, 5, 0) mm, in the pattern at (5, 5) mm"),
            HasSubstr("principal stretches 1 and 0.")));
}

// A start that is stretched further than any garment is the cause, with the place and the hint at units.
TEST(Diagnosis, StartThatIsStretchedTooFar) {
  Situation s(12.0);
  s.stepped = false;
  EXPECT_THAT(
      solve::likely_cause(s.failure()),
      AllOf(HasSubstr("at its start the fabric is stretched further than any garment: panel \"panel0\", element "),
            HasSubstr("principal stretches 12 and 1"), HasSubstr("Check that pattern and body are in mm")));
}

// Damping is advised only where there is none, and shorter steps only where steps were tried.
TEST(Diagnosis, AdvisesWhatCanBeTried) {
  Situation s;
  EXPECT_THAT(solve::likely_cause(s.failure()),
              AllOf(HasSubstr("give the stage a list \"Damping\""), Not(HasSubstr("smallest step"))));
  s.stage.damping.active = true;
  EXPECT_THAT(solve::likely_cause(s.failure()),
              AllOf(HasSubstr("\"smallest step\" (now 0.0001)"), Not(HasSubstr("Damping"))));
  s.stepped = false;
  EXPECT_THAT(solve::likely_cause(s.failure()), IsEmpty());
  s.left.total.force = 0.1;
  EXPECT_THAT(
      solve::likely_cause(s.failure()),
      AllOf(HasSubstr("the start is far from an equilibrium. Its fabric is compressed most in panel \"panel0\""),
            HasSubstr("it is stretched most in panel \"panel0\""), Not(HasSubstr("Damping"))));
  s.stage.damping.active = false;
  EXPECT_THAT(solve::likely_cause(s.failure()),
              AllOf(HasSubstr("the start is far from an equilibrium"), HasSubstr("\"Damping\"")));
  s.stage.arc_length = true;
  EXPECT_THAT(solve::likely_cause(s.failure()), AllOf(HasSubstr("path"), Not(HasSubstr("Damping"))));
}

// A load that stands still while the steps shrink has reached a limit: the load factor and the load's name are told,
// and arc length only where it can be used.
TEST(Diagnosis, TellsALoadThatCannotGrow) {
  Situation s;
  s.sheet.problem.loads.push_back(pull({Panels::node(0, 3, 0)}, solve::Vec3::UnitX()));
  s.state.load = 0.75;
  s.left.s = 0.125 + 2e-4;
  EXPECT_EQ(solve::likely_cause(s.failure()),
            "beyond load 0.75 there may be no equilibrium: the garment cannot carry more of the load \"pull\" (a limit "
            "point). \"continuation\" = \"arc length\" follows the path past it");
  s.stage.damping.active = true;
  EXPECT_THAT(solve::likely_cause(s.failure()), AllOf(HasSubstr("a limit point"), Not(HasSubstr("arc length"))));
  s.left.s = 0.25;
  EXPECT_THAT(solve::likely_cause(s.failure()), Not(HasSubstr("limit point")));
}

// A residual that fell to the last allowed iteration asks for more iterations; one that stands does not.
TEST(Diagnosis, TellsAnIterationThatWasStillConverging) {
  Situation s;
  s.left.iterations = s.newton.max_iterations;
  s.left.residual = {1.0, 1.0, 1e-2, 1e-4, 1e-6};
  EXPECT_THAT(
      solve::likely_cause(s.failure()),
      HasSubstr("the iteration was still converging; allow it more (\"most iterations\" of the list \"Solver\", "
                "now 60)"));
  s.left.residual = {1.0, 1e-2, 1e-4, 1e-4, 1e-4};
  EXPECT_THAT(solve::likely_cause(s.failure()), Not(HasSubstr("still converging")));
}

/// The cause that is told of a sleeve in a state of its own, where a step of a stage failed or, before any, its start.
std::string cause_of(const solve::Problem& problem, const solve::StageOptions& stage, const solve::State& state,
                     bool stepped) {
  const solve::Held held = find_held(problem, state, {});
  solve::Remainder left;
  left.force.assign(problem.clusters.size(), solve::Vec3::Zero());
  left.opening.assign(problem.clusters.size(), 0.0);
  left.total.force_scale = 1.0;
  left.state = state;
  const solve::NewtonOptions newton;
  return solve::likely_cause({problem, stage, newton, held, state, state, left, 0.0, stepped, false, 1});
}

// A seam whose way leads through the body is the cause, with its node and how far it has to go.
TEST(Diagnosis, SeamThroughTheBody) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  sleeve.problem.clusters[1] = {1, 7};
  EXPECT_THAT(cause_of(sleeve.problem, stage("sew"), placed_state(sleeve.problem), false),
              AllOf(HasSubstr("the way that a seam closes leads through the body: node 2 of panel \"sleeve\""),
                    HasSubstr("starts 120 mm from the node that it is sewn to")));
}

// A sleeve whose pattern is wider than the body is loose.
TEST(Diagnosis, LooseGarment) {
  Sleeve::Options o = options(12, 6);
  o.r0 = 63.0;
  o.axial = 1.0;
  const Sleeve sleeve(o, neo_hookean());
  EXPECT_THAT(
      cause_of(sleeve.problem, stage("settle"), closed_start(sleeve.problem), false),
      AllOf(HasSubstr("the garment is loose, wider than the body where it is: its fabric is compressed more than it "
                      "is stretched, most in panel \"sleeve\""),
            HasSubstr("0.9")));
}

// A sleeve that the body presses on one side only is pushed off, unless a support holds it that way.
TEST(Diagnosis, GarmentThatIsPushedOff) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  solve::State state = closed_start(sleeve.problem);
  for (size_t c = 0; c < state.position.size(); ++c) state.contact_force[c] = state.position[c][0] > 1.0 ? 0.1 : 0.0;
  const solve::StageOptions sew = stage("sew");
  EXPECT_THAT(
      cause_of(sleeve.problem, sew, state, true),
      AllOf(HasSubstr("panel \"sleeve\": it is pushed off the body, in the direction (1, 0, 0): the body pushes it "
                      "there with "),
            HasSubstr("is one missing?")));
  for (solve::Support& support : sleeve.problem.supports) support.held = {true, true, true};
  EXPECT_THAT(cause_of(sleeve.problem, sew, state, true), Not(HasSubstr("pushed off")));
}

/// A sleeve that is settled with one iteration, from rows that are crowded towards one end.
struct Hurried {
  Sleeve sleeve{options(12, 6), neo_hookean()};
  solve::SolverOptions solver;
  Hurried() { solver.newton.max_iterations = 1; }
  std::string message() {
    Recorded run(sleeve.problem, solver);
    solve::State start = closed_start(sleeve.problem);
    for (solve::Vec3& p : start.position) p[2] += 12.0 * std::sin(std::acos(-1.0) * p[2] / 110.0);
    run.simulation.set_start(start);
    return failure_of(run.simulation, stage("settle"));
  }
};

// The message of a stage holds what failed and why, the same on any number of ranks.
TEST(Diagnosis, IsInTheMessageOfTheStage) {
  EXPECT_THAT(
      Hurried().message(),
      AllOf(HasSubstr("The last attempt at its undamped end was given up after 1 iterations (\"most iterations\"). "
                      "The forces do not balance: their residual is "),
            HasSubstr("; worst at node "), HasSubstr("of panel \"sleeve\", at ("),
            HasSubstr("Likely cause: the start is far from an equilibrium: give the stage a list \"Damping\".")));
}

// A run that is to end, by the wish of a single rank, fails at the next iteration with the reason, and keeps its state.
TEST(Watch, EndsTheRunOnRequest) {
  const auto comm = Tpetra::getDefaultComm();
  Sleeve sleeve(options(12, 6), neo_hookean());
  Recorded run(sleeve.problem);
  const solve::State start = closed_start(sleeve.problem);
  run.simulation.set_start(start);
  int asked = 0;
  run.simulation.stop_when([&] {
    ++asked;
    return comm->getRank() == 0 && asked == 2 ? std::string("it is late") : std::string();
  });
  const std::string message = failure_of(run.simulation, stage("settle"));
  if (comm->getRank() == 0) {
    EXPECT_THAT(message, HasSubstr("no undamped equilibrium was found at its end, because it is late"));
  }
  EXPECT_THAT(message, HasSubstr("because it"));
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(run.simulation.state().position, start.position);
}

// A limit of time ends the stage or the run that exceeds it, and the message names the one that did.
TEST(Watch, EndsTheRunAtALimitOfTime) {
  for (const bool of_stage : {true, false}) {
    Sleeve sleeve(options(12, 6), neo_hookean());
    solve::SolverOptions solver;
    solve::StageOptions settle = stage("settle");
    (of_stage ? settle.most_time : solver.most_time) = 1e-9;
    Recorded run(sleeve.problem, solver);
    run.simulation.set_start(closed_start(sleeve.problem));
    EXPECT_THAT(failure_of(run.simulation, settle),
                HasSubstr(of_stage ? "it has taken longer than its \"most time\", 1e-09 s"
                                   : "the run has taken longer than \"most time\" of the list \"Solver\", 1e-09 s"));
  }
}

// So does a limit of the iterations of a stage.
TEST(Watch, EndsTheStageAtALimitOfIterations) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  solve::StageOptions settle = stage("settle");
  settle.most_iterations = 1;
  Recorded run(sleeve.problem);
  run.simulation.set_start(closed_start(sleeve.problem));
  EXPECT_THAT(failure_of(run.simulation, settle),
              HasSubstr("because it has taken 1 iterations, its \"most iterations in all\""));
}

// Every iteration is reported with what is sought and how far it is; the last one has converged.
TEST(Watch, ReportsIterations) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  Recorded run(sleeve.problem);
  run.simulation.set_start(closed_start(sleeve.problem));
  std::vector<solve::IterationReport> reports;
  run.simulation.observe_iterations([&](const solve::IterationReport& report) { reports.push_back(report); });
  run.simulation.run(stage("settle"));
  ASSERT_GT(reports.size(), 2u);
  EXPECT_EQ(reports.front().iteration, 0);
  EXPECT_GT(reports.front().residual, 1e-6);
  EXPECT_EQ(reports.back().stage, "stage");
  EXPECT_TRUE(reports.back().relaxing);
  EXPECT_DOUBLE_EQ(reports.back().parameter, 1.0);
  EXPECT_LT(reports.back().residual, 1e-10);
}

}  // namespace
}  // namespace toile::test
