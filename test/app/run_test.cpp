#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

using RunScene = ProgramTest;

// A run that succeeds leaves every kind of result on disk.
TEST_F(RunScene, WritesItsResults) {
  write_scene("sleeve");
  const Outcome run = toile("run scene.xml");
  EXPECT_EQ(run.status, 0) << run.err;
  for (const char* file : {"results.exo", "history.h5", "restart.h5", "pressure-curve.csv", "pressure-levels.csv",
                           "pressure.dat", "pressure.gp"})
    EXPECT_TRUE(exists(std::string("results/scene/") + file)) << file;
  EXPECT_THAT(read("results/scene/pressure-levels.csv"), HasSubstr("\nmiddle,65,"));
}

// Progress says stage, step, load, iterations and time; the summary everything that a result is judged by.
TEST_F(RunScene, PrintsProgressAndSummary) {
  write_scene("sleeve");
  const std::string out = toile("run scene.xml").out;
  EXPECT_THAT(out, AllOf(HasSubstr("[1/2] sew: step 1, "), HasSubstr(", load 0.0000, "), HasSubstr(" iterations, "),
                         HasSubstr(" elapsed, about "), HasSubstr("[2/2] settle: ")));
  EXPECT_THAT(out, AllOf(HasSubstr("pressure: "), HasSubstr("mmHg) where the garment touches"),
                         HasSubstr("largest gap of a node in contact: "), HasSubstr("forces on the garment"),
                         HasSubstr("sum over magnitudes: "), HasSubstr("dissipated by damping: ")));
  EXPECT_THAT(summary_line(out, "modules used: "),
              AllOf(HasSubstr("contact"), HasSubstr("seams"), HasSubstr("damping")));
  EXPECT_THAT(summary_line(out, "modules left out: "), AllOf(HasSubstr("dead loads"), HasSubstr("partition")));
  for (const char* phase : {"\nbody ", "\ngarment ", "\nsolve ", "\n  output ", "\ntotal "})
    EXPECT_THAT(out, HasSubstr(phase));
}

// The summary's pressure is the one of membrane theory, T/r = 0.464274 kPa at r = 60 mm and half the thickness, for the
// stretch 1.1 along and that of the mesh's 20 chords around: 0.461498 kPa at every node.
TEST_F(RunScene, ReportsPressureExtremes) {
  write_scene("sleeve");
  double least = 0.0, largest = -1.0;
  const std::string line = summary_line(toile("run scene.xml").out, "pressure: ");
  ASSERT_EQ(std::sscanf(line.c_str(), "%lf to %lf kPa", &least, &largest), 2) << line;
  EXPECT_NEAR(least, 0.461498, 2e-6);
  EXPECT_NEAR(largest, 0.461498, 2e-6);
}

// A sleeve that starts off the body and is only sewn presses evenly too: what held it at the start is gone.
TEST_F(RunScene, SewsFromOffTheBody) {
  const std::string settled = [&] {
    write_scene("sleeve");
    return summary_line(toile("run scene.xml").out, "pressure: ");
  }();
  write_scene("sleeve",
              {{"name=\"offset\" type=\"double\" value=\"0.3\"", "name=\"offset\" type=\"double\" value=\"3\""},
               {"<ParameterList name=\"settle\">\n      <Parameter name=\"type\" type=\"string\" "
                "value=\"settle\"/>\n    </ParameterList>",
                ""}});
  const Outcome run = toile("run scene.xml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, Not(HasSubstr("[2/")));
  EXPECT_EQ(summary_line(run.out, "pressure: "), settled);
}

// A quiet run that succeeds prints nothing, and writes the same files.
TEST_F(RunScene, IsQuiet) {
  write_scene("strip");
  const Outcome run = toile("run scene.xml --quiet");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(exists("results/scene/results.exo"));
}

// Fabric that left its calibrated range is a warning, which a quiet run prints too.
TEST_F(RunScene, WarnsOfFabricOutsideItsRange) {
  write_scene("strip", {{"\"itskov\"", "\"rebar\""}, {"{0, 20, 0}", "{0, 190, 0}"}});
  const Outcome run = toile("run scene.xml --quiet");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, ::testing::StartsWith("warning: outside the calibrated range of the fabric: 50 elements, "));
  EXPECT_THAT(run.err, HasSubstr(" in panel \"strip\""));
}

// --output names the folder of the results, which is made if need be, and nothing is written elsewhere.
TEST_F(RunScene, WritesWhereItIsTold) {
  write_scene("strip");
  EXPECT_EQ(toile("run scene.xml --output some/where").status, 0);
  EXPECT_TRUE(exists("some/where/results.exo"));
  EXPECT_TRUE(exists("some/where/force-curves.csv"));
  EXPECT_FALSE(exists("results"));
}

// The curves of an earlier run do not stay beside the results of a later one that has none.
TEST_F(RunScene, ReplacesEarlierResults) {
  write_scene("strip");
  write("out/pressure-levels.csv", "of an earlier run");
  write("out/notes.txt", "mine");
  EXPECT_EQ(toile("run scene.xml --output out").status, 0);
  EXPECT_FALSE(exists("out/pressure-levels.csv"));
  EXPECT_EQ(read("out/notes.txt"), "mine");
}

// Two threads, and two ranks, report the pressure of one.
TEST_F(RunScene, IsTheSameInParallel) {
  write_scene("sleeve");
  const std::string one = summary_line(toile("run scene.xml").out, "pressure: ");
  EXPECT_THAT(one, HasSubstr("kPa"));
  const Outcome threads = toile("run scene.xml --threads 2");
  EXPECT_EQ(threads.status, 0) << threads.err;
  EXPECT_EQ(summary_line(threads.out, "pressure: "), one);
  const Outcome ranks = toile("run scene.xml", 2);
  EXPECT_EQ(ranks.status, 0) << ranks.err;
  EXPECT_EQ(summary_line(ranks.out, "pressure: "), one);
  EXPECT_THAT(summary_line(ranks.out, "modules used: "), HasSubstr("partition"));
}

// A support that turns leaves its torque in torques.csv, in the history and in the summary, over its angle; fabric that
// wrinkles tells its residual stiffness and how much of it is taut, wrinkled and slack.
TEST_F(RunScene, ReportsTorqueAndWrinkles) {
  write_scene("strip", {{"<Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>",
                         "<Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>"
                         "<Parameter name=\"compression\" type=\"string\" value=\"tension field\"/>"},
                        {"<Parameter name=\"move by\" type=\"Array(double)\" value=\"{0, 20, 0}\"/>",
                         "<Parameter name=\"turn by\" type=\"double\" value=\"10\"/>"
                         "<Parameter name=\"axis point\" type=\"Array(double)\" value=\"{25, 0, 0}\"/>"},
                        {"<Parameter name=\"support\" type=\"string\" value=\"upper clamp\"/>",
                         "<Parameter name=\"support\" type=\"string\" value=\"lower clamp\"/>"}});
  const Outcome run = toile("run scene.xml");
  EXPECT_EQ(run.status, 0) << run.err;
  double taut = -1.0, wrinkled = -1.0, slack = -1.0, torque = 0.0;
  const std::string panel = summary_line(run.out, "panel \"strip\": ");
  EXPECT_THAT(panel, HasSubstr("tension field, residual stiffness 0.0001 of that of undeformed fabric; of its area "));
  ASSERT_EQ(std::sscanf(panel.c_str(), "%*[^;]; of its area %lf %% taut, %lf %% wrinkled, %lf %% slack", &taut,
                        &wrinkled, &slack),
            3)
      << panel;
  EXPECT_GT(wrinkled, 1.0);
  EXPECT_NEAR(taut + wrinkled + slack, 100.0, 0.2);
  EXPECT_THAT(run.out, HasSubstr("smallest principal stress: 0 kPa\n"));
  const std::string clamp = summary_line(run.out, "support \"upper clamp\" ");
  ASSERT_EQ(std::sscanf(clamp.c_str(), "%*[^N]N, turned by 10 deg with a torque of %lf N mm about (0, 0, 1)", &torque),
            1)
      << clamp;
  EXPECT_GT(torque, 0.0);
  const std::string csv = read("results/scene/torques.csv");
  EXPECT_THAT(csv, ::testing::StartsWith("step,load,upper clamp: angle [deg],upper clamp: torque [N mm]\n1,0,0,"));
  const std::string last = csv.substr(csv.rfind(",10,") + 4);
  EXPECT_NEAR(std::stod(last), torque, 1e-5 * torque) << csv;
  EXPECT_THAT(read("results/scene/history.h5"), HasSubstr("torque_upper_clamp"));
}

// A check of the scene that does not hold ends the run with its own status, after the results are written.
TEST_F(RunScene, FailsACheck) {
  write_scene("sleeve", {{"\"force balance\"", "\"largest pressure\""}, {"1e-6", "1e-3"}});
  const Outcome run = toile("run scene.xml");
  EXPECT_EQ(run.status, 4);
  EXPECT_THAT(run.err, HasSubstr("toile: check \"equilibrium\" does not hold: largest pressure is "));
  EXPECT_THAT(run.err, HasSubstr(", allowed: <= 0.001"));
  EXPECT_TRUE(exists("results/scene/results.exo"));
  EXPECT_THAT(run.out, HasSubstr("Summary"));
}

// `check` builds the scene, says what it found and writes nothing.
TEST_F(RunScene, ChecksWithoutSolving) {
  write_scene("sleeve");
  const Outcome check = toile("check scene.xml");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("scene.xml: valid. 210 nodes, 180 elements, 1 seams, 2 stages; cylinder"));
  EXPECT_FALSE(exists("results"));
}

}  // namespace
}  // namespace toile::test
