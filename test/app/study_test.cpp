// toile study: cases of a tube on a cylinder, whose pressure is known.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "program.hpp"
#include "toile/base/csv_file.hpp"

namespace toile::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// "name", its paths and values, and more parameters.
std::string change(const std::string& name, const std::string& paths, const std::string& values,
                   const std::string& more = "") {
  return "<ParameterList name=\"" + name + "\"><Parameter name=\"paths\" type=\"Array(string)\" value=\"{" + paths +
         "}\"/><Parameter name=\"values\" type=\"Array(string)\" value=\"{" + values + "}\"/>" + more +
         "</ParameterList>\n";
}

std::string reference(double value) {
  return "<Parameter name=\"reference\" type=\"Array(double)\" value=\"{" + std::to_string(value) + "}\"/>";
}

class StudyCommand : public ProgramTest {
 protected:
  /// Numbers of a column of a table of the study.
  std::vector<double> column(const std::string& file, const std::string& name) const {
    const base::CsvFile csv = base::read_csv(path("results/tubes/" + file), "point");
    for (const base::CsvColumn& one : csv.columns)
      if (one.name == name) return base::numbers(csv, one);
    throw std::runtime_error("no column " + name);
  }
  StudyCommand() {
    write("tube.xml",
          "<ParameterList name=\"scene\"><Parameter name=\"include\" type=\"Array(string)\" "
          "value=\"{" TOILE_SOURCE_DIR "/examples/tube.xml}\"/></ParameterList>");
  }
  void write_study(const std::string& vary, const std::string& quantity = "", const std::string& more = "") const {
    write("tubes.xml",
          "<ParameterList name=\"study\">\n<Parameter name=\"scene\" type=\"string\" value=\"tube.xml\"/>\n" + more +
              "<ParameterList name=\"Vary\">" + vary +
              "</ParameterList>\n<ParameterList name=\"Quantities\"><ParameterList name=\"pressure\">"
              "<Parameter name=\"type\" type=\"string\" value=\"level\"/>"
              "<Parameter name=\"of\" type=\"string\" value=\"middle\"/>" +
              quantity + "</ParameterList></ParameterList>\n</ParameterList>\n");
  }
};

const std::string refine = "<Parameter name=\"refine\" type=\"string\" value=\"around\"/>";
/// Only one direction is refined, so that unknowns tell the order no more.
const std::string sizes = "<Parameter name=\"sizes\" type=\"Array(double)\" value=\"{4, 2, 1}\"/>";
const std::string tolerance = "<Parameter name=\"tolerance\" type=\"double\" value=\"2\"/>";
const std::string around = "Panels/tube/elements across";

/// Of a tube of neo-Hookean fabric, C10 = 0.02 MPa and 1 mm thick, stretched to 1.2 round 60 mm, kPa.
const double exact = 1e3 * 2 * 0.02 * (1.2 * 1.2 - 1 / 1.2) / (60.0 * std::sqrt(1.2));

// Three meshes of a tube converge with second order to the exact pressure; the coarsest one that has the wanted error
// is the cheapest in unknowns; table and plots are written.
TEST_F(StudyCommand, ComparesMeshesWithTheExactPressure) {
  write_study(change("around", around, "12, 24, 48", sizes), reference(exact), refine + tolerance);
  const Outcome run = toile("study tubes.xml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3 cases: 3 right"));
  const std::vector<double> error = column("study.csv", "pressure: error");
  ASSERT_EQ(error.size(), 3U);
  EXPECT_LT(error[1], 0.3 * error[0]);
  EXPECT_LT(error[2], 0.3 * error[1]);
  EXPECT_NEAR(column("limits.csv", "order").at(0), 2.0, 0.1);
  EXPECT_NEAR(column("limits.csv", "value").at(0), exact, 1e-4 * exact);
  for (const char* file : {"error-time.png", "error-unknowns.svg", "report.txt", "cheapest.csv"})
    EXPECT_TRUE(exists(std::string("results/tubes/") + file)) << file;
}

// A figure that nothing is known to compare with is told beside the others, and neither has an error nor takes part in
// the verdict.
TEST_F(StudyCommand, AFigureIsTold) {
  write_study(change("around", around, "24"),
              reference(exact) +
                  "</ParameterList><ParameterList name=\"iterations\"><Parameter name=\"type\" "
                  "type=\"string\" value=\"figure\"/><Parameter name=\"of\" type=\"string\" "
                  "value=\"Newton iterations\"/>",
              tolerance);
  const Outcome run = toile("study tubes.xml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("1 cases: 1 right"));
  EXPECT_GT(column("study.csv", "iterations").at(0), 0.0);
  EXPECT_LT(column("study.csv", "error").at(0), 2.0);  // %
}

// Without an exact value the error is that against the extrapolated one.
TEST_F(StudyCommand, FindsItsOwnReference) {
  write_study(change("around", around, "12, 24, 48", sizes), "", refine);
  EXPECT_EQ(toile("study tubes.xml").status, 0);
  EXPECT_NEAR(column("study.csv", "pressure: reference").at(0), 0.36919, 1e-4);
  EXPECT_GT(column("study.csv", "pressure: error of the reference").at(0), 0.0);
}

// A study goes on where it was: what has ended is not run again, unless its scene is another one.
TEST_F(StudyCommand, ResumesWithWhatHasEnded) {
  write_study(change("around", around, "12, 16"));
  EXPECT_EQ(toile("study tubes.xml --jobs 2").status, 0);
  std::filesystem::remove(path("results/tubes/case-16/case.json"));
  const Outcome second = toile("study tubes.xml");
  EXPECT_THAT(second.out, HasSubstr("case-12: known"));
  EXPECT_THAT(second.out, HasSubstr("case-16: done"));
  std::string scene = read("tube.xml");
  scene.insert(scene.rfind("</"), "<Parameter name=\"title\" type=\"string\" value=\"another\"/>");
  write("tube.xml", scene);
  EXPECT_THAT(toile("study tubes.xml").out, Not(HasSubstr("from before")));
}

// A case that cannot be solved is a row with its reason, and the others have their results.
TEST_F(StudyCommand, GoesOnAfterACaseThatFails) {
  write_study(change("stiffness", "Materials/fabric/C10", "0.02, -1"));
  const Outcome run = toile("study tubes.xml");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("1 ran, 1 refused"));
  EXPECT_EQ(column("study.csv", "status"), (std::vector<double>{0, 2}));
  EXPECT_THAT(read("results/tubes/study.csv"), HasSubstr("parameter \"\"C10\"\""));
}

// A result that is not the exact one, and of which the run says nothing, is told and ends the study with status 4; so
// does a case that does not end in time.
TEST_F(StudyCommand, TellsWhatIsWrong) {
  write_study(change("around", around, "12"), reference(1.0), tolerance);
  const Outcome wrong = toile("study tubes.xml");
  EXPECT_EQ(wrong.status, 4);
  EXPECT_THAT(wrong.out, HasSubstr("1 cases: 1 wrong"));
  write_study(change("around", around, "13"), "", "<Parameter name=\"time limit\" type=\"double\" value=\"0.01\"/>");
  const Outcome endless = toile("study tubes.xml");
  EXPECT_EQ(endless.status, 4);
  EXPECT_THAT(endless.out, HasSubstr("it did not end in 0.01 s"));
}

// A case may run on several ranks, although the study itself is an MPI program.
TEST_F(StudyCommand, RunsACaseOnTwoRanks) {
  write_study(change("ranks", "run/ranks", "2"));
  const Outcome run = toile("study tubes.xml");
  EXPECT_THAT(run.out, HasSubstr("1 cases: 1 ran")) << run.err;
}

// A path that is not in the scene ends the study with status 2 before anything runs.
TEST_F(StudyCommand, RefusesAPathThatDoesNotExist) {
  write_study(change("around", "Panels/tube/elements acros", "12"));
  const Outcome run = toile("study tubes.xml");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("tubes.xml: path \"Panels/tube/elements acros\": there is no parameter \"elements "
                                 "acros\"; did you mean \"elements across\"?"));
  EXPECT_FALSE(exists("results/tubes"));
}

// doc/study-reference.md is what the program prints, so that it cannot drift.
TEST_F(StudyCommand, ReferenceIsWhatTheProgramPrints) {
  std::ostringstream committed;
  committed << std::ifstream(TOILE_SOURCE_DIR "/doc/study-reference.md").rdbuf();
  const Outcome describe = toile("study --describe --markdown");
  EXPECT_EQ(describe.status, 0);
  EXPECT_TRUE(committed.str() == describe.out)
      << "write it anew: toile study --describe --markdown > doc/study-reference.md";
}

}  // namespace
}  // namespace toile::test
