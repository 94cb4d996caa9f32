#include <fstream>
#include <sstream>

#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

using Identify = ProgramTest;

const std::string shipped = TOILE_SOURCE_DIR "/input/identify/pantyhose.xml";

// The shipped fit runs as it is: progress with the time that is left, the report, and every file of its results.
TEST_F(Identify, ShippedFit) {
  const Outcome run = toile("identify " + shipped + " --output out");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr(" left"), HasSubstr("equibiaxial-wale (fitted): rms "),
                             HasSubstr("Combinations of relative changes that the data do not determine"),
                             HasSubstr("<Parameter name=\"mu1\" type=\"double\"")));
  for (const char* file : {"material.xml", "report.txt", "curves.csv", "residuals.csv", "parameters.csv",
                           "covariance.csv", "correlation.csv", "curves.svg"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
  EXPECT_THAT(read("out/curves.csv"), HasSubstr("curve,stretch [-],data [MPa],noise [MPa],fit [MPa]\nwale,1.05,"));
  EXPECT_THAT(run.out, HasSubstr(read("out/material.xml")));
}

// So does the one with clamped strips, which tells of its second phase and of the strips.
TEST_F(Identify, ShippedFitOfStrips) {
  const Outcome run =
      toile("identify " + std::string(TOILE_SOURCE_DIR) + "/input/identify/clamped-strips.xml --output out");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("search and polish with homogeneous states: 100 %"),
                             HasSubstr("polish with clamped strips: 100 %"),
                             HasSubstr("clamped strip of 12 x 17 elements: they err by ")));
}

// A fit file or its data that cannot be used ends the program with status 2 and one message, before anything is
// written.
TEST_F(Identify, BadInput) {
  const Outcome none = toile("identify fit.xml --output out");
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("toile: fit.xml"));
  std::ostringstream text;
  text << std::ifstream(shipped).rdbuf();
  write("fit.xml", text.str());
  const Outcome no_data = toile("identify fit.xml --output out");
  EXPECT_EQ(no_data.status, 2);
  EXPECT_THAT(no_data.err, HasSubstr("cannot read the data file wale.csv"));
  EXPECT_FALSE(exists("out"));
  EXPECT_EQ(toile("identify").status, 2);
}

// A fit of one wale curve says nothing of the course: the material that it writes makes each run tell so, of the
// parameter and, where the fabric is stretched along the course, of the stretch that no test reached.
TEST_F(Identify, RunsTellWhatTheDataLeftOpen) {
  std::ostringstream rows;
  rows << "stretch [-], nominal stress [MPa]\n";
  for (int i = 1; i <= 10; ++i) {
    const double stretch = 1.0 + 0.05 * i;
    rows << stretch << ", " << 0.02 * (stretch - 1.0 / (stretch * stretch)) + 0.05 * (stretch - 1.0) << "\n";
  }
  write("wale.csv", rows.str());
  const auto parameter = [](const std::string& name, const std::string& type, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
  };
  const auto list = [](const std::string& name, const std::string& content) {
    return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
  };
  std::string free;
  for (const char* name : {"C10", "c0", "d0"})
    free += list(name, parameter("lower", "double", "0.001") + parameter("upper", "double", "1"));
  write("fit.xml",
        list("fit", list("Material", list("fabric", parameter("type", "string", "rebar"))) + list("Free", free) +
                        list("Data", list("wale", parameter("file", "string", "wale.csv") +
                                                      parameter("kind", "string", "uniaxial") +
                                                      parameter("angle", "double", "0"))) +
                        list("Algorithm", parameter("generations", "int", "20") + parameter("starts", "int", "1"))));
  const Outcome fit = toile("identify fit.xml --output fitted");
  ASSERT_EQ(fit.status, 0) << fit.err;
  EXPECT_THAT(read("fitted/material.xml"),
              AllOf(HasSubstr("name=\"not determined\" type=\"Array(string)\" value=\"{d0}\""),
                    HasSubstr("name=\"tested wale stretch\" type=\"double\" value=\"1.5\""),
                    HasSubstr("name=\"tested course stretch\" type=\"double\" value=\"1\"")));

  const std::string open = "fabric \"fabric\": the data of its fit did not determine d0: pressures that depend on it";
  const std::string beyond = "panel \"strip\" is stretched along the course to 1.";
  const std::string itskov =
      "<ParameterList name=\"fabric\">\n      <Parameter name=\"type\" type=\"string\" value=\"itskov\"/>\n      "
      "<Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>\n    </ParameterList>";
  const std::string size = "<Parameter name=\"width\"";
  write_scene("strip", {{itskov, read("fitted/material.xml")}});
  const Outcome wale = toile("run scene.xml --output out");
  EXPECT_EQ(wale.status, 0) << wale.err;
  EXPECT_THAT(wale.err, AllOf(HasSubstr(open), Not(HasSubstr(beyond))));
  write_scene("strip", {{itskov, read("fitted/material.xml")}, {size, parameter("wale angle", "double", "0") + size}});
  const Outcome course = toile("run scene.xml --output out");
  EXPECT_EQ(course.status, 0) << course.err;
  EXPECT_THAT(course.err, AllOf(HasSubstr(open), HasSubstr(beyond),
                                HasSubstr("the tests that its fabric \"fabric\" was fitted to reach 1 there")));
}

// doc/identify-reference.md is what the program prints, so that it cannot drift.
TEST_F(Identify, Reference) {
  std::ostringstream committed;
  committed << std::ifstream(TOILE_SOURCE_DIR "/doc/identify-reference.md").rdbuf();
  const Outcome describe = toile("identify --describe --markdown");
  EXPECT_EQ(describe.status, 0);
  EXPECT_TRUE(committed.str() == describe.out)
      << "write it anew: toile identify --describe --markdown > doc/identify-reference.md";
}

}  // namespace
}  // namespace toile::test
