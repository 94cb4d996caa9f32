// Stages that cannot reach their end: what is said, and that the run ends by itself.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class Failures : public ProgramTest {
 protected:
  /// Runs a scene of test/data/cases/failures.
  Outcome run(const std::string& scene, const std::string& arguments = "", int ranks = 0) const {
    return toile("run " TOILE_SOURCE_DIR "/test/data/cases/failures/" + scene + ".xml --output out " + arguments,
                 ranks);
  }
};

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// A sleeve on a cone that nothing holds slides to the thin end: status 3, and the message names the panel, the
// direction and what would hold it.
TEST_F(Failures, ConeWithoutSupportSlides) {
  const Outcome cone = run("cone");
  EXPECT_EQ(cone.status, 3);
  EXPECT_THAT(cone.err, AllOf(HasSubstr("panel \"sleeve\": it slides along the body, in the direction ("),
                              HasSubstr("no support holds it. Hold an end of it along the limb (list \"Supports\")")));
  EXPECT_THAT(cone.err, Not(AnyOf(HasSubstr("smaller"), HasSubstr("Damping"))));
}

// The same on a finer mesh, stopped by its limit of iterations while it slides: the message says that it does.
TEST_F(Failures, ConeThatIsStoppedSlides) {
  write_scene("../../data/cases/failures/cone",
              {{"type=\"int\" value=\"16\"", "type=\"int\" value=\"32\""},
               {"<Parameter name=\"type\" type=\"string\" value=\"sew\"/>",
                "<Parameter name=\"type\" type=\"string\" value=\"sew\"/>"
                "<Parameter name=\"most iterations in all\" type=\"int\" value=\"1000\"/>"}});
  const Outcome cone = toile("run scene.xml --output out");
  EXPECT_EQ(cone.status, 3);
  EXPECT_THAT(cone.err, AllOf(HasSubstr("it has taken 1000 iterations"),
                              HasSubstr("panel \"sleeve\": it slides along the body, in the direction (")));
}

// Held at its lower end, the sleeve stays on the cone: its pressure in the middle is the tension round it over the
// radius of curvature, radius / cosine of the cone's slope.
TEST_F(Failures, ConeWithASupportIsInEquilibrium) {
  write_scene("../../data/cases/failures/cone",
              {{"type=\"int\" value=\"16\"", "type=\"int\" value=\"40\""},
               {"type=\"int\" value=\"4\"", "type=\"int\" value=\"10\""},
               {"  <ParameterList name=\"Contact\">",
                "  <ParameterList name=\"Supports\"><ParameterList name=\"lower end\"><Parameter name=\"on\" "
                "type=\"Array(string)\" value=\"{sleeve.bottom}\"/><Parameter name=\"hold\" type=\"string\" "
                "value=\"z\"/></ParameterList></ParameterList>\n  <ParameterList name=\"Contact\">"}});
  const Outcome cone = toile("run scene.xml --output out");
  ASSERT_EQ(cone.status, 0) << cone.err;
  std::istringstream table(read("out/pressure-levels.csv"));
  std::vector<std::string> titles, cells;
  for (std::vector<std::string>* row : {&titles, &cells}) {
    std::string line, cell;
    std::getline(table, line);
    for (std::istringstream stream(line); std::getline(stream, cell, ',');) row->push_back(cell);
  }
  const auto value = [&](const std::string& title) {
    return std::stod(cells.at(static_cast<size_t>(std::find(titles.begin(), titles.end(), title) - titles.begin())));
  };
  EXPECT_NEAR(value("mean pressure [kPa]"), value("Laplace T/r [kPa]") * std::cos(std::atan(0.1)),
              0.002 * value("mean pressure [kPa]"));
}

// A sleeve wider than its body, placed free of stress, compressed on the body, or of a fabric that carries no
// compression, has neither pressure nor energy, and a warning says that it does not press; or it is refused as loose.
TEST_F(Failures, SleeveWiderThanTheBodyIsLoose) {
  for (const char* scene : {"loose", "loose-placed-on-body", "loose-tension-field"}) {
    const Outcome loose = run(scene);
    ASSERT_THAT(loose.status, AnyOf(0, 3)) << scene << loose.err;
    if (loose.status == 3) {
      EXPECT_THAT(loose.err, AllOf(HasSubstr("Likely cause: the garment is loose, wider than the body"),
                                   HasSubstr("\"compression\" = \"tension field\"")));
      continue;
    }
    EXPECT_THAT(loose.err, HasSubstr("warning: the garment presses on the body nowhere")) << scene;
    EXPECT_THAT(summary_line(loose.out, "pressure: "), HasSubstr("0 to 0 kPa")) << scene;
    EXPECT_LT(std::abs(std::strtod(summary_line(loose.out, "strain energy: ").c_str(), nullptr)), 1e-12) << scene;
  }
}

// Where such a sleeve grazes the body, on this mesh at nine nodes, the forces are round-off: no pressure in summary and
// tables, and no warning of pressures of single nodes.
TEST_F(Failures, RoundOffPressesNothing) {
  write_scene("../../data/cases/failures/loose-placed-on-body",
              {{"type=\"int\" value=\"24\"", "type=\"int\" value=\"40\""},
               {"type=\"int\" value=\"5\"", "type=\"int\" value=\"10\""}});
  const Outcome loose = toile("run scene.xml --output out");
  ASSERT_EQ(loose.status, 0) << loose.err;
  EXPECT_THAT(loose.err, Not(HasSubstr("touch the body while all their neighbours are free")));
  EXPECT_THAT(summary_line(loose.out, "pressure: "), StartsWith("0 to 0 kPa"));
  EXPECT_THAT(read("out/pressure-levels.csv"), HasSubstr("\nmiddle,100,0,0,"));
}

// A garment that a forgotten seam leaves open is told of by its start, before minutes are spent on it, and ends by
// itself: beside the body, where nothing presses, or in a failure that says that it is pushed off.
TEST_F(Failures, ForgottenSeamEndsBesideTheBody) {
  const Outcome open = run("forgotten-seam");
  EXPECT_THAT(open.err, HasSubstr("warning: back.right and front.left face each other on the body, 13.5 mm apart, and "
                                  "are not sewn: is a seam forgotten?"));
  EXPECT_THAT(open.status, AnyOf(3, 4)) << open.err;
  EXPECT_THAT(open.err, HasSubstr(open.status == 4 ? "Is a seam forgotten? If not," : "it is pushed off the body"));
}

// Stopped on its way off the body, where minutes would not bring it further, it is told that it is pushed off.
TEST_F(Failures, ForgottenSeamThatIsStoppedIsPushedOff) {
  const std::string sew = "<Parameter name=\"type\" type=\"string\" value=\"sew\"/>";
  write_scene("../../data/cases/failures/forgotten-seam",
              {{sew, sew + "<Parameter name=\"most iterations in all\" type=\"int\" value=\"150\"/>"}});
  const Outcome open = toile("run scene.xml --output out");
  EXPECT_EQ(open.status, 3);
  EXPECT_THAT(open.err, AllOf(HasSubstr("it has taken 150 iterations"),
                              HasSubstr("Likely cause: the part of panels \"front\", \"back\": it is pushed off the "
                                        "body, in the direction ")));
}

const Edits pattern_in_cm = {{"\"width\" type=\"double\" value=\"200\"", "\"width\" type=\"double\" value=\"20\""},
                             {"\"height\" type=\"double\" value=\"100\"", "\"height\" type=\"double\" value=\"10\""}};

// A pattern in cm on a body in mm: the stretch of the start is told, with the panel and the units as the likely cause;
// on several ranks as well.
TEST_F(Failures, PatternInCentimetres) {
  write_scene("sleeve", pattern_in_cm);
  for (const int ranks : {0, 2, 3}) {
    const Outcome failed = toile("run scene.xml --output out", ranks);
    EXPECT_EQ(failed.status, 3) << ranks;
    EXPECT_THAT(failed.err, AllOf(HasSubstr("The fabric has no energy at 720 of 720 points; worst in panel \"sleeve\""),
                                  HasSubstr("at its start the fabric is stretched further than any garment"),
                                  HasSubstr("stretch 11 along the wale and 17.9 along the course"),
                                  HasSubstr("Check that pattern and body are in mm")));
    EXPECT_EQ(count(failed.err, "Likely cause"), 1u);
  }
}

// Inside a step a line is printed when none was for the interval of the heartbeat, by the first rank alone.
TEST_F(Failures, HeartbeatTellsOfIterations) {
  write_scene("sleeve");
  for (const int ranks : {0, 2}) {
    const Outcome told = toile("run scene.xml --output out --heartbeat 0", ranks);
    EXPECT_EQ(told.status, 0) << told.err;
    EXPECT_THAT(told.out, HasSubstr("[1/2] sew: seeking 0.0 %, iteration 0, residual "));
    EXPECT_THAT(told.out, HasSubstr("[1/2] sew: seeking the final state, iteration 0, residual "));
    EXPECT_EQ(count(told.out, "[2/2] settle: seeking the final state, iteration 0, "), 1u);
  }
}

// A run that is quiet, or quick, has no such line.
TEST_F(Failures, HeartbeatIsSilentWhereNotNeeded) {
  write_scene("sleeve");
  EXPECT_EQ(toile("run scene.xml --output out --heartbeat 0 --quiet").out, "");
  EXPECT_THAT(toile("run scene.xml --output out --heartbeat 1e6").out, Not(HasSubstr("seeking")));
}

/// A strip that takes a thousand steps.
const Edits long_way = {{"<Parameter name=\"first step\" type=\"double\" value=\"0.25\"/>",
                         "<Parameter name=\"first step\" type=\"double\" value=\"1e-3\"/>"
                         "<Parameter name=\"largest step\" type=\"double\" value=\"1e-3\"/>"
                         "<Parameter name=\"most steps\" type=\"int\" value=\"100000\"/>"}};

// A limit of time ends the stage with status 3; the message names the limit, and the last state is kept.
TEST_F(Failures, LimitOfTimeEndsTheStage) {
  write_scene("strip", long_way);
  std::string text = read("scene.xml");
  const std::string type = "<Parameter name=\"type\" type=\"string\" value=\"load\"/>";
  write("scene.xml", text.replace(text.find(type), type.size(),
                                  type + "<Parameter name=\"most time\" type=\"double\" value=\"0.2\"/>"));
  const Outcome failed = toile("run scene.xml --output out");
  EXPECT_EQ(failed.status, 3);
  EXPECT_THAT(failed.err, AllOf(HasSubstr("stage \"pull\" could not reach its end: it stopped at load 0"),
                                HasSubstr("because it has taken longer than its \"most time\", 0.2 s"),
                                Not(HasSubstr("Likely cause"))));
}

// A run that is asked to end by SIGTERM ends with status 3, says so, and its last state is on disk.
TEST_F(Failures, SignalEndsTheRun) {
  write_scene("strip", long_way);
  write("toile.sh", "'" TOILE_PROGRAM
                    "' run scene.xml --output out 2> said.txt & run=$!\n"
                    "while kill -0 $run && ! test -e out/restart.h5; do sleep 0.05; done\n"
                    "kill -TERM $run; wait $run\n");
  const int status = std::system(("cd '" + path(".") + "' && sh toile.sh > /dev/null 2>&1").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_THAT(read("said.txt"),
              AllOf(HasSubstr("because it was asked to end (SIGTERM)"), HasSubstr("The last converged state, step ")));
}

}  // namespace
}  // namespace toile::test
