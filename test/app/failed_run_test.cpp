#include <cmath>

#include "exodus.hpp"
#include "program.hpp"
#include "toile/result/state_file.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using FailedRun = ProgramTest;

// A strip whose clamps meet has no equilibrium: the run ends with status 3, names the stage and how far it
// came, and the last converged state is on disk, complete, in both files.
TEST_F(FailedRun, LeavesTheLastConvergedState) {
  write_scene("strip", {{"{0, 20, 0}", "{0, -100, 0}"},
                        {"value=\"load\"/>",
                         "value=\"load\"/><Parameter name=\"smallest step\" type=\"double\" value=\"0.01\"/>"}});
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err,
              AllOf(HasSubstr("toile: stage \"pull\" could not reach its end: it stopped at load 0."),
                    HasSubstr("\"smallest step\" 0.01"), HasSubstr("out/results.exo"), HasSubstr("out/restart.h5")));
  const ExodusStep last(path("out/results.exo"));
  const int steps = last.steps;
  EXPECT_GT(steps, 1);
  const result::StateData state = result::read_state(path("out/restart.h5"));
  EXPECT_EQ(state.integers.at("statistics: steps"), std::vector<int>{steps});
  EXPECT_EQ(state.metadata.at("stage name"), "pull");
  const std::vector<double>& position = state.reals.at("state: position");
  ASSERT_EQ(position.size(), 3u * 66u);
  for (size_t i = 0; i < position.size(); ++i) EXPECT_NEAR(position[i], last.position[i % 3][i / 3], 1e-12) << i;
  const double load = state.reals.at("state: load")[0];
  EXPECT_GT(load, 0.25);
  EXPECT_LT(load, 1.0);
  EXPECT_THAT(run.err, HasSubstr("The last converged state, step " + std::to_string(steps) + ","));
}

/// The strip of the hosiery rebar fabric, its polynomials taken beyond their range, pulled along the course.
std::vector<std::pair<std::string, std::string>> literal_rebar(const std::string& movement) {
  const std::string set = "<Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>",
                    shape = "<Parameter name=\"shape\"";
  return {{"\"itskov\"", "\"rebar\""},
          {set, set + "<Parameter name=\"calibrated strain\" type=\"double\" value=\"3\"/>"},
          {shape, "<Parameter name=\"wale angle\" type=\"double\" value=\"0\"/>" + shape},
          {"{0, 20, 0}", movement}};
}

// A run that fails because its fabric gives way says where and in which state.
TEST_F(FailedRun, NamesWhereTheFabricGivesWay) {
  write_scene("strip", literal_rebar("{0, 260, 0}"));
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("toile: stage \"pull\" could not reach its end"),
                             HasSubstr("In the last converged state the fabric loses strong ellipticity"),
                             HasSubstr("of panel \"strip\"; worst in panel \"strip\", element "),
                             HasSubstr("softens in tension"), HasSubstr("The last converged state, step ")));
}

// A stage that runs out of steps says so.
TEST_F(FailedRun, RunsOutOfSteps) {
  write_scene("strip", {{"value=\"load\"/>",
                         "value=\"load\"/><Parameter name=\"most steps\" type=\"int\" value=\"3\"/>"
                         "<Parameter name=\"largest step\" type=\"double\" value=\"0.25\"/>"}});
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("stage \"pull\" could not reach its end: it stopped at load 0.75"),
                             HasSubstr("most steps")));
  EXPECT_GT(ExodusStep(path("out/results.exo")).steps, 2);
}

// A run whose first step fails writes its start to a file of its own, and leaves the results of an earlier run as they
// are.
TEST_F(FailedRun, WritesItsStartIfNothingWasAccepted) {
  write_scene("sleeve", {{"<ParameterList name=\"Stages\">",
                          "<ParameterList name=\"Solver\"><Parameter name=\"most iterations\" type=\"int\" "
                          "value=\"1\"/></ParameterList><ParameterList name=\"Stages\">"}});
  write("out/results.exo", "of an earlier run");
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("stage \"sew\" could not reach its end"),
                             HasSubstr("No step was accepted; the start is in out/start.exo.")));
  EXPECT_EQ(read("out/results.exo"), "of an earlier run");
  const ExodusStep start(path("out/start.exo"));
  EXPECT_EQ(start.steps, 1);
  EXPECT_NEAR(std::hypot(start.position[0][0], start.position[1][0]), 60.3, 1e-6);
}

// Sewing that fails after accepted steps says how far it came, keeps its last state, and tells its notes as well.
TEST_F(FailedRun, LeavesTheLastStateOfSewing) {
  write_scene("sleeve",
              {{"<ParameterList name=\"Damping\"/>",
                "<ParameterList name=\"Damping\"/><Parameter name=\"most steps\" type=\"int\" value=\"3\"/>"}});
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, HasSubstr("toile: stage \"sew\" could not reach its end: it stopped at "));
  EXPECT_THAT(run.err, HasSubstr(" % of the seams' closing"));
  EXPECT_THAT(run.out, HasSubstr("note: stage \"sew\": nothing resists a "));
  const int steps = ExodusStep(path("out/results.exo")).steps;
  EXPECT_GT(steps, 1);
  const result::StateData state = result::read_state(path("out/restart.h5"));
  EXPECT_EQ(state.integers.at("statistics: steps"), std::vector<int>{steps});
  EXPECT_GT(state.reals.at("state: seam")[0], 0.0);
  EXPECT_LT(state.reals.at("state: seam")[0], 1.0);
}

// A settle that fails at once claims no state that it has not got.
TEST_F(FailedRun, SettleThatAcceptsNothing) {
  write_scene("sleeve", {{"<Parameter name=\"type\" type=\"string\" value=\"sew\"/>",
                          "<Parameter name=\"type\" type=\"string\" value=\"settle\"/>"},
                         {"<ParameterList name=\"Stages\">",
                          "<ParameterList name=\"Solver\"><Parameter name=\"most iterations\" type=\"int\" "
                          "value=\"1\"/></ParameterList><ParameterList name=\"Stages\">"}});
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("stage \"sew\": no undamped equilibrium was found at its end, and no step of it "
                                       "was accepted. The last attempt at its undamped end was given up after 1 "
                                       "iterations (\"most iterations\"). The forces do not balance: "),
                             HasSubstr(" No step was accepted; the start is in out/start.exo.")));
}

}  // namespace
}  // namespace toile::test
