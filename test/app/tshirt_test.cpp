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

/// Pressure (kPa) and its error at each of the scene's points: columns 4 and 5 of pressure-points.csv.
std::vector<std::pair<double, double>> point_pressures(const std::string& csv) {
  std::vector<std::pair<double, double>> all;
  std::istringstream rows(csv);
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    const size_t name_end = row.front() == '"' ? row.find("\",") + 1 : row.find(',');
    std::istringstream cells(row.substr(name_end + 1));
    std::vector<double> values;
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::strtod(cell.c_str(), nullptr));
    all.emplace_back(values.at(3), values.at(4));
  }
  return all;
}

class TShirt : public ProgramTest {
 protected:
  /// Runs it with its bodice placed so far from where the scene has it, towards the back, mm.
  Outcome run(double towards_back) const {
    write("scene.xml",
          "<ParameterList name=\"scene\"><Parameter name=\"include\" type=\"Array(string)\" value=\"{" TOILE_SOURCE_DIR
          "/input/tshirt-coarse.xml}\"/><ParameterList name=\"Pattern\"><ParameterList name=\"Placement\"><Parameter "
          "name=\"origin\" type=\"Array(double)\" value=\"{0, " +
              std::to_string(towards_back) + ", 905}\"/></ParameterList></ParameterList></ParameterList>");
    return toile("run scene.xml --output out");
  }
};

// Four panels come round a real body and settle undamped: what the hem is held with balances the body, fabric does not
// pass through fabric, and the pressure at mirrored points of a body that is nearly symmetric agrees within its error.
// Panels that start elsewhere end at the same pressures.
TEST_F(TShirt, SettlesWhereverItStarts) {
  const Outcome shirt = run(0.0);
  ASSERT_EQ(shirt.status, 0) << shirt.err;
  EXPECT_THAT(shirt.err, Not(HasSubstr("passes through")));
  double body = 0.0, hem = 0.0, x = 0.0, y = 0.0;
  ASSERT_EQ(std::sscanf(summary_line(shirt.out, "body (").c_str(), "%lf, %lf, %lf", &x, &y, &body), 3);
  ASSERT_EQ(std::sscanf(summary_line(shirt.out, "support \"hem\" (").c_str(), "%lf, %lf, %lf", &x, &y, &hem), 3);
  EXPECT_GT(body, 1.0);
  EXPECT_NEAR(body, -hem, 1e-4 * body);
  const auto pressure = point_pressures(read("out/pressure-points.csv"));
  ASSERT_EQ(pressure.size(), 8U);
  const auto [left, left_error] = pressure[0];
  const auto [right, right_error] = pressure[1];
  EXPECT_GT(left, 1.0);
  EXPECT_NEAR(left, right, left_error + right_error);
  const Outcome moved = run(15.0);
  ASSERT_EQ(moved.status, 0) << moved.err;
  const auto again = point_pressures(read("out/pressure-points.csv"));
  for (size_t p = 0; p < pressure.size(); ++p) EXPECT_NEAR(again[p].first, pressure[p].first, 1e-4) << p;  // kPa
}

}  // namespace
}  // namespace toile::test
