// The shipped T-shirt, coarse.
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A pressure and its error, kPa, of each row of a table: the two columns, counted from 0 behind the name.
std::vector<std::pair<double, double>> pressures(const std::string& csv, size_t pressure, size_t error) {
  std::vector<std::pair<double, double>> all;
  std::istringstream rows(csv);
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    const size_t name_end = row.front() == '"' ? row.find("\",") + 1 : row.find(',');
    std::istringstream cells(row.substr(name_end + 1));
    std::vector<double> values;
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::strtod(cell.c_str(), nullptr));
    all.emplace_back(values.at(pressure), values.at(error));
  }
  return all;
}

std::vector<std::pair<double, double>> point_pressures(const std::string& csv) {
  return pressures(csv, 3, 4);
}

std::vector<std::pair<double, double>> level_pressures(const std::string& csv) {
  return pressures(csv, 1, 15);
}

class TShirt : public ProgramTest {
 protected:
  /// Runs a shipped scene with the list "Pattern" changed.
  Outcome run_with(const std::string& shipped, const std::string& pattern, const std::string& results) const {
    write("scene.xml",
          "<ParameterList name=\"scene\"><Parameter name=\"include\" type=\"Array(string)\" value=\"{" TOILE_SOURCE_DIR
          "/input/" +
              shipped + "}\"/><ParameterList name=\"Pattern\">" + pattern + "</ParameterList></ParameterList>");
    return toile("run scene.xml --output " + results);
  }
  /// Runs it with its bodice placed so far from where the scene has it, towards the back, mm.
  Outcome run(double towards_back) const {
    return run_with("tshirt-coarse.xml",
                    "<ParameterList name=\"Placement\"><Parameter name=\"origin\" type=\"Array(double)\" value=\"{0, " +
                        std::to_string(towards_back) + ", 905}\"/></ParameterList>",
                    "out");
  }
};

// Four panels come round a real body and settle undamped: what the hem is held with balances the body, fabric does not
// pass through fabric, and the pressure at mirrored points of a body that is nearly symmetric agrees within its error.
// Panels that start elsewhere end at the same pressures.
TEST_F(TShirt, SettlesWhereverItStarts) {
  const Outcome shirt = run(0.0);
  ASSERT_EQ(shirt.status, 0) << shirt.err;
  EXPECT_THAT(shirt.err, Not(HasSubstr("passes through")));
  EXPECT_THAT(shirt.err, Not(HasSubstr("over each other")));
  double body = 0.0, hem = 0.0, x = 0.0, y = 0.0;
  ASSERT_EQ(std::sscanf(summary_line(shirt.out, "body (").c_str(), "%lf, %lf, %lf", &x, &y, &body), 3);
  ASSERT_EQ(std::sscanf(summary_line(shirt.out, "support \"hem\" (").c_str(), "%lf, %lf, %lf", &x, &y, &hem), 3);
  EXPECT_GT(body, 1.0);
  EXPECT_NEAR(body, -hem, 1e-4 * body);
  const auto pressure = point_pressures(read("out/pressure-points.csv"));
  ASSERT_EQ(pressure.size(), 11U);
  const auto [left, left_error] = pressure[0];
  const auto [right, right_error] = pressure[1];
  EXPECT_GT(left, 1.0);
  EXPECT_NEAR(left, right, left_error + right_error);
  EXPECT_GT(pressure[8].first, 1.0);  // on the body's bust points
  EXPECT_NEAR(pressure[8].first, pressure[9].first, pressure[8].second + pressure[9].second);
  const Outcome moved = run(15.0);
  ASSERT_EQ(moved.status, 0) << moved.err;
  const auto again = point_pressures(read("out/pressure-points.csv"));
  for (size_t p = 0; p < pressure.size(); ++p) EXPECT_NEAR(again[p].first, pressure[p].first, 1e-4) << p;  // kPa
}

// The sewing path, from flat panels by continuation in the closing of the seams, ends in the state that the drape
// starts beside: the same pressure at every point and level, and the same error of it. The residual of both is 1e-10.
TEST_F(TShirt, SewnAndDrapedAreTheSame) {
  const std::string coarser = "<Parameter name=\"element size\" type=\"double\" value=\"24\"/>";
  for (const std::string scene : {"coarse", "sewn"}) {
    const Outcome outcome = run_with("tshirt-" + scene + ".xml", coarser, scene);
    ASSERT_EQ(outcome.status, 0) << scene << outcome.err;
    EXPECT_EQ(summary_line(outcome.out, "modules used").find("sewing by continuation") != std::string::npos,
              scene == "sewn");
  }
  const auto same = [](const auto& draped, const auto& sewn, size_t rows) {
    ASSERT_EQ(draped.size(), rows);
    ASSERT_EQ(sewn.size(), rows);
    for (size_t p = 0; p < rows; ++p) {
      EXPECT_NEAR(sewn[p].first, draped[p].first, 1e-6) << p;  // kPa
      EXPECT_NEAR(sewn[p].second, draped[p].second, 1e-6) << p;
    }
  };
  same(point_pressures(read("coarse/pressure-points.csv")), point_pressures(read("sewn/pressure-points.csv")), 11);
  same(level_pressures(read("coarse/pressure-levels.csv")), level_pressures(read("sewn/pressure-levels.csv")), 5);
}

}  // namespace
}  // namespace toile::test
