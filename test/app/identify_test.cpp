#include <fstream>
#include <sstream>

#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

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
