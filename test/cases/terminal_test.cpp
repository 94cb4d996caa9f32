// What a run tells when it ends, and the tables that it leaves.
#include <cmath>
#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

using Terminal = ProgramTest;

std::string pulled_along(const std::string& direction, int by) {
  return R"xml(name="hold" type="string" value="direction"/>
      <Parameter name="direction" type="Array(double)" value=")xml" +
         direction + R"xml("/>
      <Parameter name="move along" type="double" value=")xml" +
         std::to_string(by) + "\"/>";
}

// The levels in mmHg with their error, in kPa and relative to the first; the stretch of each panel; the largest
// pressure with its place; the files. The sleeve's equilibrium is uniform, and a stress of -2e-11 kPa is no
// compression.
TEST_F(Terminal, ShowsWhatTheRunIsFor) {
  write_scene("sleeve");
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, ContainsRegex("middle +[0-9.]+ \\+- [0-9.]+ +[0-9.]+ +mesh [0-9.]+ +100 %"));
  EXPECT_THAT(run.out, ContainsRegex("panel +wale +course\n  sleeve +[0-9.]+ to [0-9.]+ +[0-9.]+ to [0-9.]+"));
  EXPECT_THAT(run.out, HasSubstr("Largest pressure away from supports: "));
  EXPECT_THAT(run.out, HasSubstr(" kPa) in panel \"sleeve\" at ("));
  EXPECT_THAT(run.out, HasSubstr("Files in out: results.exo history.h5 restart.h5 run.json reactions.csv"));
}

// A sleeve with a free end has no stress along its axis: -2e-11 kPa is round-off, shown as 0, and no compression.
TEST_F(Terminal, NoiseIsNoCompression) {
  write_scene("sleeve", {{R"x(    <ParameterList name="top">
      <Parameter name="on" type="Array(string)" value="{sleeve.top}"/>
      <Parameter name="hold" type="string" value="z"/>
    </ParameterList>
)x",
                          ""}});
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("smallest principal stress: 0 kPa\n"));
  EXPECT_THAT(run.out, Not(HasSubstr("real fabric wrinkles there")));
}

// A modulus in kPa makes a thousand times the pressure: no garment presses with more than 200 mmHg, and it is told why
// this one seems to.
TEST_F(Terminal, WarnsOfAPressureThatNoGarmentHas) {
  write_scene("sleeve", {{"<Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>",
                          "<Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>"
                          "<Parameter name=\"C10\" type=\"double\" value=\"9.3\"/>"}});
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, AllOf(HasSubstr("no garment presses with more than 200 mmHg"),
                             HasSubstr("Is a modulus given in kPa? Moduli and stresses are in MPa")));
}

// A stage that fails leaves its tables all the same, with numbers that read back exactly.
TEST_F(Terminal, TablesOfAFailedRunAreWritten) {
  write_scene("strip", {{"{0, 20, 0}", "{0, -100, 0}"},
                        {"value=\"load\"/>",
                         "value=\"load\"/><Parameter name=\"smallest step\" type=\"double\" value=\"0.01\"/>"}});
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 3);
  const std::vector<std::string> reactions = last_row(read("out/reactions.csv"));
  EXPECT_THAT(read("out/reactions.csv"), ::testing::StartsWith("step,load,support "));
  ASSERT_EQ(reactions.size(), 11u);
  const double lower = std::stod(reactions[6]), upper = std::stod(reactions[9]);
  EXPECT_NEAR(lower, -upper, 1e-6 * std::abs(lower)) << "the clamps pull against each other";
  EXPECT_GT(reactions[6].size(), 15u) << "all digits";
  EXPECT_TRUE(exists("out/force-curves.csv"));
}

// Distances are written where no force curve is asked for.
TEST_F(Terminal, DistancesHaveATableOfTheirOwn) {
  write_scene("strip", {{R"(    <ParameterList name="Force curves">
      <ParameterList name="wale">
        <Parameter name="support" type="string" value="upper clamp"/>
        <Parameter name="length" type="double" value="100"/>
)",
                         R"(    <ParameterList name="Distances">
      <ParameterList name="length">
        <Parameter name="first" type="string" value="strip.bottom"/>
        <Parameter name="second" type="string" value="strip.top"/>
)"}});
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(read("out/distances.csv"), ::testing::StartsWith("step,load,length [mm]\n"));
  EXPECT_NEAR(std::stod(last_row(read("out/distances.csv")).at(2)), 120.0, 1e-9);
}

// The force of a support that moves along a direction is the reaction along that direction, whatever its axes: a strip
// pulled along y has the force curve of one that is moved by the same way, and so has one whose direction looks back.
TEST_F(Terminal, ForceCurvesOfDirectionsAreTheirReactions) {
  const std::string held = R"xml(name="hold" type="string" value="xyz"/>
      <Parameter name="move by" type="Array(double)" value="{0, 20, 0}"/>)xml";
  const std::string along_y = R"xml(name="hold" type="string" value="y"/>
      <Parameter name="move by" type="Array(double)" value="{0, 20, 0}"/>)xml";
  std::vector<std::vector<std::string>> rows;
  for (const std::string& support : {along_y, pulled_along("{0, 1, 0}", 20), pulled_along("{0, -3, 0}", -20)}) {
    write_scene("strip", {{held, support}});
    const Outcome run = toile("run scene.xml --output out");
    ASSERT_EQ(run.status, 0) << run.err;
    rows.push_back(last_row(read("out/force-curves.csv")));
    ASSERT_EQ(rows.back().size(), 4u);
    EXPECT_EQ(rows.back()[2], rows.front()[2]);
    EXPECT_GT(std::stod(rows.back()[3]), 0.1);
    EXPECT_NEAR(std::stod(rows.back()[3]), std::stod(rows.front()[3]), 1e-8);
  }
}

}  // namespace
}  // namespace toile::test
