// Starts that cannot be right: refused or warned of before anything is solved. Starts that are right, but once failed.
#include <cmath>
#include <cstdlib>

#include "app/exodus.hpp"
#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Starts : public ProgramTest {
 protected:
  void write_case(const std::string& name, const Edits& edits = {}) const {
    write_scene("../../data/cases/starts/" + name, edits);
  }
  /// Refused by check and by run with the same message, and the results of an earlier run stay.
  void expect_refused(const ::testing::Matcher<std::string>& message) const {
    write("out/results.exo", "of an earlier run");
    for (const char* command : {"check scene.xml", "run scene.xml --output out"}) {
      const Outcome outcome = toile(command);
      EXPECT_EQ(outcome.status, 2) << command;
      EXPECT_THAT(outcome.err, message) << command;
    }
    EXPECT_EQ(read("out/results.exo"), "of an earlier run");
  }
};

/// The first number of a line of the summary.
double number_after(const std::string& out, const std::string& label) {
  return std::atof(summary_line(out, label).c_str());
}

const std::string ends =
    "<ParameterList name=\"bottom\">\n      <Parameter name=\"on\" type=\"Array(string)\" "
    "value=\"{sleeve.bottom}\"/>\n      <Parameter name=\"hold\" type=\"string\" value=\"z\"/>";

// A sleeve whose seam is sewn from its far end would be a Moebius band: refused with the seam, and how it would be
// right.
TEST_F(Starts, RefuseATwistedSeam) {
  const std::string second = "<Parameter name=\"second\" type=\"string\" value=\"sleeve.right\"/>";
  write_scene("sleeve", {{second, second + "<Parameter name=\"reversed\" type=\"bool\" value=\"true\"/>"}});
  expect_refused(AllOf(HasSubstr("scene > Seams > side: parameter \"reversed\" = true"), HasSubstr("Moebius band"),
                       HasSubstr("Leave \"reversed\" out")));
}

// Left sewn to left and right to right lead through the leg: refused with both seams and the nearer edges.
TEST_F(Starts, RefuseSeamsThroughTheBody) {
  write_case(
      "halves",
      {{"\"back.right\"", "\"back.other\""}, {"\"back.left\"", "\"back.right\""}, {"\"back.other\"", "\"back.left\""}});
  expect_refused(AllOf(HasSubstr("scene > Seams > one: parameter \"second\" = \"back.left\""),
                       HasSubstr("leads through the body"), HasSubstr("back.right is much nearer to front.left"),
                       HasSubstr("scene > Seams > other: parameter \"second\" = \"back.right\"")));
}

// Two panels laid over each other, both at the angle of the front, are refused where they are sewn round the leg, with
// what turns one of them to the other side.
TEST_F(Starts, RefusePanelsOnTheSameSide) {
  write_case("halves", {{"value=\"180.0\"", "value=\"0.0\""}});
  expect_refused(AllOf(HasSubstr("scene > Seams > one: parameter \"second\" = \"back.right\""),
                       HasSubstr("leads through the body"), HasSubstr("back.left is much nearer to front.left (0 mm)"),
                       HasSubstr("turn a panel round the body (\"angle\" of its placement)")));
}

// The control: sides that face each other give Laplace's pressure, 1.0931 kPa.
TEST_F(Starts, TakeSeamsBetweenFacingSides) {
  write_case("halves");
  const Outcome run = toile("run scene.xml --output out");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_NEAR(number_after(run.out, "  pressure: "), 1.0931, 0.003 * 1.0931);
}

// A support that holds two corners apart which a seam sews together is refused with both names.
TEST_F(Starts, RefuseASupportAgainstASeam) {
  std::string all = ends;
  all.replace(all.find("\"z\""), 3, "\"xyz\"");
  write_scene("sleeve", {{ends, all}});
  expect_refused(AllOf(HasSubstr("scene > Supports > bottom: parameter \"hold\" = \"xyz\""),
                       HasSubstr("contradicts the seam \"side\""), HasSubstr("do not hold y there"),
                       HasSubstr("\"hold\" = \"along the limb\"")));
}

// Panels and supports with names that results.exo cannot hold, and two whose fields would share a name, are refused.
TEST_F(Starts, RefuseNamesThatTheResultsCannotHold) {
  const std::string long_name(58, 'x');
  write_scene("strip", {{"strip", long_name}});
  expect_refused(AllOf(HasSubstr("scene > Panels > " + long_name), HasSubstr(".bottom\" of 65 characters"),
                       HasSubstr("at most 64"), HasSubstr("shorten the name by 1")));
  const std::string turn = "<Parameter name=\"hold\" type=\"string\" value=\"xyz\"/>";
  const Edits turning = {{turn, turn + "<Parameter name=\"turn by\" type=\"double\" value=\"2\"/>"},
                         {"value=\"upper clamp\"", "value=\"plane\""}};
  Edits equal = turning, too_long = turning;
  equal.insert(equal.end(), {{"\"lower clamp\"", "\"clamp-a\""}, {"\"upper clamp\"", "\"clamp a\""}});
  write_scene("strip", equal);
  expect_refused(AllOf(HasSubstr("scene > Supports > clamp a: this support and \"clamp-a\" would both have the field "
                                 "\"torque_clamp_a\""),
                       HasSubstr("give one of them another name")));
  too_long.push_back({"\"lower clamp\"", "\"" + long_name + "\""});
  write_scene("strip", too_long);
  expect_refused(AllOf(HasSubstr("scene > Supports > " + long_name), HasSubstr("\" of 65 characters")));
  write_scene("sleeve", {{"\"sleeve\"", "\"body\""}, {"sleeve.", "body."}});
  expect_refused(HasSubstr("scene > Panels > body: a panel cannot be named \"body\""));
}

// A pattern in centimetres is warned of with its stretch, its unit and what it would be.
TEST_F(Starts, WarnOfAPatternInCentimetres) {
  write_scene("sleeve", {{"\"width\" type=\"double\" value=\"200\"", "\"width\" type=\"double\" value=\"20\""},
                         {"\"height\" type=\"double\" value=\"100\"", "\"height\" type=\"double\" value=\"10\""}});
  const Outcome check = toile("check scene.xml");
  EXPECT_EQ(check.status, 0);
  EXPECT_THAT(check.err, AllOf(HasSubstr("stretched to 11 along the wale and 17.9 along the course"),
                               HasSubstr("as if the pattern were in centimetres")));
}

// What is printed before a run and by a check: a line for the panel, the seam, what is inside the body, the pressure.
TEST_F(Starts, AreToldByCheckAndRun) {
  write_scene("sleeve");
  const Outcome check = toile("check scene.xml"), run = toile("run scene.xml --output out");
  for (const std::string& out : {check.out, run.out})
    EXPECT_THAT(out, AllOf(HasSubstr("Start\n  panel \"sleeve\": stretch 1.1 along the wale, 1.7"),
                           HasSubstr("round the body, seams closed, 1.8"),
                           HasSubstr("\n  seam \"side\": sleeve.left to sleeve.right, 18.9 mm apart on average"),
                           HasSubstr("\n  inside the body: no node\n  pressure of the fabric as it is placed, seams "
                                     "open: nine tenths below 0.4")));
  EXPECT_EQ(check.err, "");
  EXPECT_FALSE(exists("out/start.exo"));
}

// A check writes the start where it is told to, with the fields of results, also of a start that it refuses.
TEST_F(Starts, AreWrittenByCheck) {
  std::string second = "<Parameter name=\"second\" type=\"string\" value=\"sleeve.right\"/>";
  for (const bool reversed : {false, true}) {
    write_scene("sleeve", {{second, second + "<Parameter name=\"reversed\" type=\"bool\" value=\"" +
                                        (reversed ? "true" : "false") + "\"/>"}});
    const std::string folder = reversed ? "bad" : "good";
    EXPECT_EQ(toile("check scene.xml --output " + folder).status, reversed ? 2 : 0);
    const ExodusStep start(path(folder + "/start.exo"));
    EXPECT_EQ(start.steps, 1);
    ASSERT_GT(start.nodes, 210);
    const std::vector<double> gap = start.nodal("gap");
    for (size_t n = 0; n < 210; ++n) {
      EXPECT_NEAR(std::hypot(start.position[0][n], start.position[1][n]), 60.3, 1e-6) << n;
      EXPECT_NEAR(gap[n], 0.3, 1e-6) << n;
    }
  }
}

/// The band over the cylinder of radius 60 mm that starts at x and goes to x = 20 mm.
Edits band_from(double x) {
  return {{"{62.0, -100.0, 0.0}", "{" + std::to_string(x) + ", -100.0, 0.0}"},
          {"{-42.0, 0.0, 0.0}", "{" + std::to_string(20.0 - x) + ", 0.0, 0.0}"}};
}

// Unstressed fabric near the body is not pulled onto it: a band that starts 2 mm or 3 mm off the body, or in it, ends
// in the same state. Path 2 (82.462 + 60 x 0.43162) mm over 200, F = 0.2319 N, on the body 2 F x 0.41834 = 0.1941 N,
// F/(20 l^-1/2)/60 = 0.2012 kPa.
TEST_F(Starts, OfABandNearTheBodyAllEndAlike) {
  for (const double x : {62.0, 63.0, 20.0}) {
    write_case("band", band_from(x));
    const Outcome run = toile("run scene.xml --output out");
    EXPECT_EQ(run.status, 0) << x << run.err;
    EXPECT_NEAR(number_after(run.out, "    body ("), 0.1941, 0.003 * 0.1941) << x;
    EXPECT_NEAR(number_after(run.out, "\"left\" (-0.0968767, "), -0.2104, 0.003 * 0.2104) << x;
    EXPECT_NEAR(number_after(run.out.substr(run.out.find("  pressure: ")), " to "), 0.2012, 0.003 * 0.2012) << x;
    if (x < 60.0)
      EXPECT_THAT(run.err, HasSubstr("panel \"band\" starts 40 mm inside the body"));
    else
      EXPECT_THAT(run.err, HasSubstr("that does not close round the body")) << x;
  }
}

// A band that hangs unstressed 2 or 3 mm off the body is in equilibrium: no pressure, no energy, nothing moves,
// and it is told that its shape is one of many, not that it is unstable.
TEST_F(Starts, OfABandAtRestStay) {
  for (const double x : {62.0, 63.0}) {
    Edits edits = band_from(x);
    edits.back().second = "{0.0, 0.0, 0.0}";
    edits.push_back({"value=\"load\"", "value=\"settle\""});
    edits.push_back({"<ParameterList name=\"Damping\">\n      </ParameterList>", ""});
    write_case("band", edits);
    const Outcome run = toile("run scene.xml --output out");
    EXPECT_EQ(run.status, 0) << x << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("pressure: 0 to 0 kPa"), HasSubstr("strain energy: 0 N mm"),
                               HasSubstr("its fabric carries no tension at its end")))
        << x;
    EXPECT_THAT(run.err, Not(HasSubstr("not stable"))) << x;
    const ExodusStep last(path("out/results.exo"));
    for (size_t n = 0; n < 82; ++n) EXPECT_NEAR(last.position[0][n], x, 1e-9) << n;
  }
}

}  // namespace
}  // namespace toile::test
