#include <exodusII.h>

#include "program.hpp"
#include "toile/result/state_file.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using FailedRun = ProgramTest;

int exodus_steps(const std::string& file) {
  int cpu_size = sizeof(double), disk_size = 0;
  float version = 0.0F;
  const int id = ex_open(file.c_str(), EX_READ, &cpu_size, &disk_size, &version);
  if (id < 0) return -1;
  const auto steps = static_cast<int>(ex_inquire_int(id, EX_INQ_TIME));
  ex_close(id);
  return steps;
}

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
  const int steps = exodus_steps(path("out/results.exo"));
  EXPECT_GT(steps, 1);
  const result::StateData state = result::read_state(path("out/restart.h5"));
  EXPECT_EQ(state.integers.at("step"), std::vector<int>{steps});
  EXPECT_EQ(state.metadata.at("stage"), "pull");
  EXPECT_EQ(state.reals.at("position").size(), 3u * 66u);
  const double load = state.reals.at("seam_load_parameter")[1];
  EXPECT_GT(load, 0.25);
  EXPECT_LT(load, 1.0);
  EXPECT_THAT(run.err, HasSubstr("The last converged state, step " + std::to_string(steps) + ","));
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
  EXPECT_GT(exodus_steps(path("out/results.exo")), 2);
}

// A run whose first step fails says that nothing was written, and leaves the results of an earlier run as they are.
TEST_F(FailedRun, LeavesEarlierResultsIfNothingWasAccepted) {
  write_scene("sleeve", {{"<ParameterList name=\"Stages\">",
                          "<ParameterList name=\"Solver\"><Parameter name=\"most iterations\" type=\"int\" "
                          "value=\"1\"/></ParameterList><ParameterList name=\"Stages\">"}});
  write("out/results.exo", "of an earlier run");
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 3);
  EXPECT_THAT(run.err, AllOf(HasSubstr("stage \"sew\" could not reach its end"),
                             HasSubstr("No step was accepted, and nothing was written to out.")));
  EXPECT_EQ(read("out/results.exo"), "of an earlier run");
}

}  // namespace
}  // namespace toile::test
