// toile compare, as its user meets it: table, plot, exit status, and what is said of bad input.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Compare : public ProgramTest {
 protected:
  Compare() {
    std::filesystem::create_directory(path("run"));
    write("run/pressure-levels.csv",
          "level,mean pressure [kPa],mean pressure [mmHg],Laplace T/r [kPa],error of the mean pressure [kPa]\n"
          "B,3.0,22.50186,,0.1\nC,2.0,15.00124,,0.05\n");
    write("run/pressure-points.csv", "point,pressure [kPa],its error [kPa]\n\"1 bust, left\",1.5,0.2\n2 back,1.0,\n");
  }
  Outcome compare(const std::string& rows, const std::string& titles = "name,pressure [kPa],scatter [kPa]") const {
    write("measured.csv", titles + "\n" + rows);
    return toile("compare run measured.csv");
  }
  void expect_refused(const Outcome& outcome, const std::string& message) const {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(exists("run/pressure-compared.csv"));
  }
};

// Deviations are computed less measured: their mean has its sign, the largest is that of the largest amount; bars that
// have a common point agree.
TEST_F(Compare, PlacesWithinBothScatters) {
  const Outcome outcome = compare("B,2.8,0.15\nC,2.02,0\n\"1 bust, left\",1.53,0.1\n");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("mean deviation     0.050 kPa, 0.38 mmHg"),
                                 HasSubstr("largest deviation  0.200 kPa, 1.50 mmHg, at B")));
  EXPECT_EQ(read("run/pressure-compared.csv"),
            "name,measured [kPa],its scatter [kPa],computed [kPa],its error [kPa],deviation [kPa],within both\n"
            "B,2.8,0.15,3,0.1,0.2,yes\nC,2.02,0,2,0.05,-0.02,yes\n\"1 bust, left\",1.53,0.1,1.5,0.2,-0.03,yes\n");
  for (const char* end : {".dat", ".gp", ".svg", ".png"})
    EXPECT_TRUE(exists(std::string("run/pressure-compared") + end));
}

// An error that is not 0 is shown with the digit that says so.
TEST_F(Compare, SmallErrors) {
  write("run/pressure-levels.csv", "level,mean pressure [kPa],error of the mean pressure [kPa]\nB,2.8,0.0002\n");
  EXPECT_THAT(compare("B,2.8,0\n").out, HasSubstr("B      2.800 +- 0.000  2.8000 +- 0.0002"));
}

// A place whose bars have no common point is named, and is a check that did not hold; table and plot are there.
TEST_F(Compare, PlaceBeyondBothScatters) {
  const Outcome outcome = compare("B,2.8,0.05\nC,2.02,0\n");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("differ by more than scatter and error together: B"));
  EXPECT_THAT(read("run/pressure-compared.csv"), HasSubstr("B,2.8,0.05,3,0.1,0.2,no\nC,2.02,0,2,0.05,-0.02,yes\n"));
}

// A computed value whose error is as large as itself decides nothing where the bars meet: no agreement, with the status
// of a check that is not decided. Where they do not meet the values differ; 0 without an error is exact.
TEST_F(Compare, ErrorAsLargeAsTheValue) {
  write("run/pressure-levels.csv",
        "level,mean pressure [kPa],error of the mean pressure [kPa]\n"
        "wild,0.188,12.66\njust,0.5,0.5\nless,0.5,0.499\nfar,0.188,0.2\nbare,0,0\n");
  const Outcome outcome = compare("wild,5,0.01\njust,0.4,0\nless,0.4,0\nfar,5,0.01\nbare,0,0\n");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("differ by more than scatter and error together: far; not decided, since the "
                                     "computed pressure is no larger than its error: wild, just\n"));
  EXPECT_THAT(outcome.out, HasSubstr("within both        2 yes, 1 no, 2 not decided\n"));
  EXPECT_THAT(read("run/pressure-compared.csv"),
              AllOf(HasSubstr("-4.812,not decided\njust,0.4,0,0.5,0.5,0.1,not decided\nless,0.4,0,0.5,0.499,0.1,yes\n"),
                    HasSubstr("-4.812,no\nbare,0,0,0,0,0,yes\n")));
  const Outcome open = compare("wild,5,0.01\n");
  EXPECT_EQ(open.status, 4);
  EXPECT_THAT(open.err, Not(HasSubstr("differ by more")));
}

// Measured values in mmHg are laid beside the same kPa.
TEST_F(Compare, MeasuredInMmhg) {
  const Outcome outcome = compare("C,15.00124,0.375031\n", "name,pressure [mmHg],scatter [mmHg]");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read("run/pressure-compared.csv"), HasSubstr("C,2,0.05,2,0.05,0,yes\n"));
}

// Each column has its own unit; one quantity in two columns is refused with the line of the titles.
TEST_F(Compare, UnitsOfColumns) {
  const Outcome outcome = compare("C,15.00124,0.05\n", "name,pressure [mmHg],scatter [kPa]");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read("run/pressure-compared.csv"), HasSubstr("C,2,0.05,2,0.05,0,yes\n"));
  std::filesystem::remove(path("run/pressure-compared.csv"));
  expect_refused(compare("C,2,15,0.05\n", "name,pressure [kPa],pressure [mmHg],scatter [kPa]"),
                 "measured.csv, line 1: the columns 2 and 3 are both \"pressure\"; keep one of them");
  expect_refused(compare("C,15 mmHg,0.05\n"), "line 2, column 2 \"pressure\": \"15 mmHg\", expected a finite number");
}

// Measurements of one place are averaged, with the scatter of all their readings, and that is said: 2.9 and 3.1 +- 0.1
// are 3 +- 0.1 sqrt(2).
TEST_F(Compare, PlaceMeasuredTwice) {
  const Outcome outcome = compare("B,2.9,0.1\nC,2.02,0\nB,3.1,0.1\n");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("note: \"B\" was measured 2 times (lines 2, 4): compared is the mean"));
  EXPECT_THAT(read("run/pressure-compared.csv"),
              HasSubstr("\nB,3,0.1414213562,3,0.1,0,yes\nC,2.02,0,2,0.05,-0.02,yes\n"));
  std::filesystem::remove(path("run/pressure-compared.csv"));
  expect_refused(
      compare("B,1,2,3,2.9,0.1\nB,1,2,4,3.1,0.1\n", "name,x [mm],y [mm],z [mm],pressure [kPa],scatter [kPa]"),
      "measured.csv: \"B\" has several positions (lines 2, 3); give each place a name of its own");
}

// Bad input is refused with what is wrong, where, and what is allowed.
TEST_F(Compare, BadInput) {
  expect_refused(compare("BB,2.8,0.1\n"), "measured.csv: \"BB\" is no level or point of the run in run");
  expect_refused(compare("B,2.8,0.1\n", "name,pressure [Pa],scatter [kPa]"),
                 "has the unit \"Pa\"; allowed in its title: [kPa], [mmHg]");
  expect_refused(compare("B,2.8,0.1\n", "name,pressure [kPa],scater [kPa]"),
                 "measured.csv, line 1: there is no column \"scatter\"; is it \"scater\"? (found: name, pressure, "
                 "scater)");
  expect_refused(compare("B,2.8\n", "name,pressure [kPa]"), "no column \"scatter\" (found: name, pressure)\n");
  expect_refused(compare("B,2.8,-0.1\n"), "line 2, column 3 \"scatter\": \"-0.1\", expected 0 or more");
  expect_refused(compare(""), "no pressure follows the line of titles");
  expect_refused(compare("2 back,1,0.1\n"), "pressure-points.csv, line 3, column 3 \"its error\": the cell is empty");
  expect_refused(toile("compare nowhere measured.csv"), "neither pressure-levels.csv nor pressure-points.csv is there");
}

// Rows with a position and rows without one are not mixed, and each has a name; columns without any position do no
// harm.
TEST_F(Compare, NamesAndPositionsMixed) {
  const std::string titles = "name,x [mm],y [mm],z [mm],pressure [kPa],scatter [kPa]";
  expect_refused(compare("B,,,,2.8,0.15\nknee,60,0,110,1,0.1\n", titles),
                 "measured.csv: line 3 has a position x, y, z, and line 2 has none");
  expect_refused(compare("knee,60,,110,1,0.1\n", titles), "line 2, column 3 \"y\": the cell is empty");
  expect_refused(compare(",60,0,110,1,0.1\n", titles),
                 "line 2, column 1 \"name\": the cell is empty; give each place a name");
  EXPECT_EQ(compare("B,,,,2.8,0.15\n", titles).status, 0);
}

// Places that are given by positions: what the run shows on its body there, T/r of the sleeve and nothing beyond it.
TEST_F(Compare, Positions) {
  std::ifstream stream(TOILE_SOURCE_DIR "/test/data/cases/pressure/sleeve.xml");
  write("scene.xml", std::string((std::istreambuf_iterator<char>(stream)), {}));
  ASSERT_EQ(toile("run scene.xml --output sleeve").status, 0);
  const std::string titles = "name,x [mm],y [mm],z [mm],pressure [kPa],scatter [kPa]\n";
  write("measured.csv", titles + "sensor 1,0,61.5,101,1.0931,0.01\nsensor 2,-70,0,112,1.0931,0.01\nfoot,60,0,20,0,0\n");
  const Outcome outcome = toile("compare sleeve measured.csv --output compared");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(read("compared/pressure-compared.csv"),
              AllOf(HasSubstr("name,x [mm],y [mm],z [mm],measured [kPa]"),
                    HasSubstr("sensor 1,0,61.5,101,1.0931,0.01,1.09"), HasSubstr("foot,60,0,20,0,0,0,0,0,yes")));
  EXPECT_THAT(outcome.out, HasSubstr("note: no fabric lies at \"foot\", so 0 is computed there"));
  // The hem is held at a height of 60 mm: within a facet of the body, of 5 mm, nothing presses below and all above it.
  write("measured.csv", titles + "above,0,60,60.5,1.0931,0.01\nbelow,0,60,59.5,0,0\n");
  const Outcome hem = toile("compare sleeve measured.csv --output compared");
  EXPECT_EQ(hem.status, 0) << hem.err;
  EXPECT_THAT(hem.out, HasSubstr("note: no fabric lies at \"below\""));
  EXPECT_THAT(hem.out, Not(HasSubstr("\"above\"")));
  EXPECT_THAT(read("compared/pressure-compared.csv"),
              AllOf(HasSubstr("above,0,60,60.5,1.0931,0.01,1.09"), HasSubstr("below,0,60,59.5,0,0,0,0,0,yes")));
  write("measured.csv", titles + "sensor 1,0,90,101,1.0931,0.01\n");
  EXPECT_THAT(
      toile("compare sleeve measured.csv").err,
      HasSubstr("measured.csv: \"sensor 1\" at (0, 90, 101) lies 30 mm from the body's skin; allowed are 20 mm"));
  write("measured.csv", "name,x [mm],y [mm],pressure [kPa],scatter [kPa]\nsensor 1,0,61.5,1.0931,0.01\n");
  EXPECT_THAT(toile("compare sleeve measured.csv").err, HasSubstr("measured.csv, line 1: there is no column \"z\""));
}

// The shown part of an endless body ends with the fabric, at its lower hem: no fabric lies beyond it, as none does at
// the upper hem, beyond which the body is shown, and be the sensor's place 10 mm outside the skin.
TEST_F(Compare, PositionsBeyondTheShownSkin) {
  std::ifstream stream(TOILE_SOURCE_DIR "/input/benchmarks/sleeve-cylinder.xml");
  write("scene.xml", std::string((std::istreambuf_iterator<char>(stream)), {}));
  ASSERT_EQ(toile("run scene.xml --output sleeve").status, 0);
  write("measured.csv",
        "name,x [mm],y [mm],z [mm],pressure [kPa],scatter [kPa]\n"
        "low hem,60,0,0.5,0.1849,0.001\nhigh hem,60,0,109.5,0.1849,0.001\nlifted,0,70,0.5,0.1849,0.001\n"
        "tilted,42,43,0.5,0.1849,0.001\n1 below,60,0,-1,0,0\n2 below,0,60,-2,0,0\n15 below,42,43,-15,0,0\n"
        "2 below and lifted,0,70,-2,0,0\n2 above,60,0,112,0,0\n");
  const Outcome outcome = toile("compare sleeve measured.csv --output compared");
  EXPECT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  for (const char* bare : {"1 below", "2 below", "15 below", "2 below and lifted", "2 above"})
    EXPECT_THAT(outcome.out,
                HasSubstr(std::string("note: no fabric lies at \"") + bare + "\", so 0 is computed there"));
  for (const char* pressed : {"low hem", "high hem", "lifted", "tilted"})
    EXPECT_THAT(outcome.out, Not(HasSubstr(std::string("lies at \"") + pressed)));
}

}  // namespace
}  // namespace toile::test
