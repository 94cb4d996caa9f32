// Runs that fail on several ranks end with the status and the one message of a single rank, and do not hang.
#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

/// Messages of the program, not of mpirun.
int messages(const std::string& err) {
  int count = err.rfind("toile: ", 0) == 0 ? 1 : 0;
  for (size_t at = err.find("\ntoile: "); at != std::string::npos; at = err.find("\ntoile: ", at + 1)) ++count;
  return count;
}

class FailureOnThreeRanks : public ProgramTest {
 protected:
  void expect(int status, const std::string& message) const {
    const Outcome run = toile("run scene.xml --output out", 3);
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(messages(run.err), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(message));
  }
};

// Bad input.
TEST_F(FailureOnThreeRanks, BadInput) {
  write_scene("sleeve", {{"\"radius\"", "\"radus\""}});
  expect(2, "unknown parameter \"radus\"; did you mean \"radius\"?");
}

// A results folder that only the first rank finds out to be unusable.
TEST_F(FailureOnThreeRanks, FolderOfTheResults) {
  write_scene("sleeve");
  write("out", "a file");
  expect(2, "cannot make the folder of the results");
}

// A stage that cannot reach its end.
TEST_F(FailureOnThreeRanks, Solve) {
  write_scene("sleeve",
              {{"<ParameterList name=\"Damping\"/>",
                "<ParameterList name=\"Damping\"/><Parameter name=\"most steps\" type=\"int\" value=\"2\"/>"}});
  expect(3, "stage \"sew\" could not reach its end");
}

// A check of the scene that does not hold.
TEST_F(FailureOnThreeRanks, Check) {
  write_scene("sleeve", {{"\"force balance\"", "\"largest pressure\""}, {"1e-6", "1e-3"}});
  expect(4, "check \"equilibrium\" does not hold");
}

}  // namespace
}  // namespace toile::test
