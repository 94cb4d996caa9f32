// Runs that end before their end, and go on with --restart.
#include <cmath>
#include <cstdlib>

#include "app/exodus.hpp"
#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string real(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"double\" value=\"" + value + "\"/>";
}

std::string most_steps(int steps) {
  return "<Parameter name=\"most steps\" type=\"int\" value=\"" + std::to_string(steps) + "\"/>";
}

class Restart : public ProgramTest {
 protected:
  /// A strip that is pulled in steps of 2 %, at most so many of them.
  void write_strip(int steps = 200, const Edits& edits = {}) const {
    Edits all = {
        {real("first step", "0.25"), real("first step", "0.02") + real("largest step", "0.02") + most_steps(steps)}};
    all.insert(all.end(), edits.begin(), edits.end());
    write_scene("strip", all);
  }

  /// The files of two folders are the same, but for the wall times of the steps.
  void expect_same_results(const std::string& a, const std::string& b) const {
    EXPECT_EQ(read(a + "/reactions.csv"), read(b + "/reactions.csv"));
    const int steps = ExodusStep(path(a + "/results.exo")).steps;
    for (const char* file : {"/results.exo", "/history.h5"}) {
      const std::string first = read(a + file), second = read(b + file);
      ASSERT_EQ(first.size(), second.size()) << file;
      int differ = 0;
      for (size_t i = 0; i < first.size(); ++i) differ += first[i] != second[i] ? 1 : 0;
      EXPECT_LE(differ, 8 * steps) << file;
    }
  }
};

// A run that is killed, again and again, and taken up each time leaves the results of one that was left alone, bit for
// bit.
TEST_F(Restart, AfterKills) {
  write_strip();
  ASSERT_EQ(toile("run scene.xml --output whole").status, 0);
  write("kill.sh",
        "arguments=\n"
        "for wait in 0.05 0.1 0.15; do\n"
        "  '" TOILE_PROGRAM
        "' run scene.xml --output parts --quiet $arguments & run=$!\n"
        "  while kill -0 $run && ! test -e parts/restart.h5; do sleep 0.02; done\n"
        "  sleep $wait; kill -9 $run; wait $run\n"
        "  arguments=--restart\n"
        "done\n");
  std::system(("cd '" + path(".") + "' && sh kill.sh > /dev/null 2>&1").c_str());
  const Outcome rest = toile("run scene.xml --output parts --restart");
  EXPECT_EQ(rest.status, 0) << rest.err;
  EXPECT_THAT(rest.out, HasSubstr("Going on after step "));
  expect_same_results("whole", "parts");
}

// A run that is asked to end says how to go on, and does so with the same bits; one that has ended already writes its
// results again.
TEST_F(Restart, AfterASignal) {
  write_strip();
  ASSERT_EQ(toile("run scene.xml --output whole").status, 0);
  write("stop.sh", "'" TOILE_PROGRAM
                   "' run scene.xml --output parts 2> said.txt & run=$!\n"
                   "while kill -0 $run && ! test -e parts/restart.h5; do sleep 0.02; done\n"
                   "kill -INT $run; wait $run\n");
  const int status = std::system(("cd '" + path(".") + "' && sh stop.sh > /dev/null 2>&1").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_THAT(read("said.txt"), HasSubstr("toile run scene.xml --output parts --restart"));
  for (int again = 0; again < 2; ++again) {
    const Outcome rest = toile("run scene.xml --output parts --restart");
    EXPECT_EQ(rest.status, 0) << rest.err;
    expect_same_results("whole", "parts");
  }
}

// Sewing with damping onto a body goes on after a limit of its steps was raised, on one rank with the same bits, on two
// with the same positions to 1e-8 mm.
TEST_F(Restart, WithMoreStepsAndRanks) {
  const std::string damping = "<ParameterList name=\"Damping\"/>";
  const auto sew = [&](int steps) { write_scene("sleeve", {{damping, damping + most_steps(steps)}}); };
  sew(200);
  ASSERT_EQ(toile("run scene.xml --output whole").status, 0);
  const ExodusStep whole(path("whole/results.exo"));
  for (const int ranks : {0, 2}) {
    sew(3);
    const Outcome first = toile("run scene.xml --output parts");
    EXPECT_EQ(first.status, 3);
    EXPECT_THAT(first.err, HasSubstr("toile run scene.xml --output parts --restart"));
    sew(200);
    const Outcome rest = toile("run scene.xml --output parts --restart", ranks);
    EXPECT_EQ(rest.status, 0) << rest.err;
    if (ranks == 0) expect_same_results("whole", "parts");
    const ExodusStep parts(path("parts/results.exo"));
    ASSERT_EQ(parts.nodes, whole.nodes);
    EXPECT_EQ(parts.steps, whole.steps);
    for (size_t d = 0; d < 3; ++d)
      for (size_t n = 0; n < whole.position[d].size(); ++n)
        EXPECT_NEAR(parts.position[d][n], whole.position[d][n], 1e-8) << n;
  }
}

// What is not whole, or of another scene, is refused with the reason; the results are then as they were.
TEST_F(Restart, RefusesWhatItCannotGoOnFrom) {
  write_strip();
  EXPECT_THAT(toile("run scene.xml --output out --restart").err,
              HasSubstr("there is no out/restart.h5 to go on from; run the scene without --restart"));
  write_strip(4);
  EXPECT_EQ(toile("run scene.xml --output out").status, 3);
  const std::string results = read("out/results.exo"), state = read("out/restart.h5");
  const auto refused = [&] {
    const Outcome run = toile("run scene.xml --output out --restart");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(read("out/results.exo"), results);
    return run.err;
  };
  write_strip(200, {{"{0, 20, 0}", "{0, 25, 0}"}});
  EXPECT_THAT(refused(), AllOf(HasSubstr("which is of another scene"),
                               HasSubstr("Supports > upper clamp > move by: \"{0, 20, 0}\" in the run so far, "
                                         "\"{0, 25, 0}\" in the scene")));
  write_strip(200);
  write("out/restart.h5", state.substr(0, state.size() / 2));
  EXPECT_THAT(refused(), HasSubstr("it was cut off"));
  std::string damaged = state;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 4);
  write("out/restart.h5", damaged);
  EXPECT_THAT(refused(), AllOf(HasSubstr("it is damaged"), Not(HasSubstr("--restart"))));
}

}  // namespace
}  // namespace toile::test
