// The main job of the README, as it is shipped.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "exodus.hpp"
#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

/// The row of a level in pressure-levels.csv: its numbers after the name, 0 for a text.
std::vector<double> level_row(const std::string& csv, const std::string& level) {
  const size_t at = csv.find("\n" + level + ",");
  if (at == std::string::npos) return {};
  std::istringstream row(csv.substr(at + level.size() + 2, csv.find('\n', at + 1) - at - level.size() - 2));
  std::vector<double> values;
  for (std::string cell; std::getline(row, cell, ',');)
    values.push_back(cell.empty() ? NAN : std::strtod(cell.c_str(), nullptr));
  return values;
}

class ShippedLeg : public ProgramTest {
 protected:
  void expect_written_field_is_the_summary(const std::string& out) const;
};

// The file holds what the summary says: the pressure's extremes, and the resultant of the contact forces as the body's
// force. The pressure, which is recovered from tensions, adds up to the same force within 0.2 %, but for the ends:
// a held row presses the body with a line force too, which is no pressure.
void ShippedLeg::expect_written_field_is_the_summary(const std::string& out) const {
  double least = 0.0, largest = 0.0;
  std::array<double, 3> reported{};
  ASSERT_EQ(std::sscanf(summary_line(out, "pressure: ").c_str(), "%lf to %lf kPa", &least, &largest), 2);
  ASSERT_EQ(std::sscanf(summary_line(out, "body (").c_str(), "%lf, %lf, %lf", &reported[0], &reported[1], &reported[2]),
            3);
  const ExodusStep last(path("out/results.exo"));
  const std::vector<double> pressure = last.nodal("pressure"), area = last.nodal("area"),
                            force = last.nodal("contact_force");
  ASSERT_EQ(pressure.size(), static_cast<size_t>(last.nodes));
  double written_least = HUGE_VAL, written_largest = 0.0, on_body = 0.0;
  std::array<double, 3> resultant{};
  double forces = 0.0, pressures = 0.0;
  const std::vector<double> normal[3] = {last.nodal("normal_x"), last.nodal("normal_y"), last.nodal("normal_z")};
  for (size_t n = 0; n < pressure.size(); ++n) {
    if (area[n] == 0.0) {  // the body's vertices, behind the garment's nodes
      on_body = std::max(on_body, pressure[n]);
      continue;
    }
    if (pressure[n] > 0.0) written_least = std::min(written_least, pressure[n]);
    written_largest = std::max(written_largest, pressure[n]);
    for (size_t d = 0; d < 3; ++d) resultant[d] += force[n] * normal[d][n];
    constexpr double ends[2] = {100.0, 740.0};  // mm, heights of the held rows
    if (std::min(std::abs(last.position[2][n] - ends[0]), std::abs(last.position[2][n] - ends[1])) < 1e-3) continue;
    forces += force[n];
    pressures += 1e-3 * pressure[n] * area[n];  // kPa mm^2 to N
  }
  EXPECT_NEAR(written_least, least, 1e-5 * least);  // the summary prints six digits
  EXPECT_NEAR(written_largest, largest, 1e-5 * largest);
  EXPECT_GT(std::abs(reported[2]), 0.1);
  for (size_t d = 0; d < 3; ++d) EXPECT_NEAR(resultant[d], reported[d], 1e-5 * std::abs(reported[2])) << d;
  EXPECT_NEAR(pressures, forces, 2e-3 * forces);
  EXPECT_GT(on_body, 0.5 * largest);
  EXPECT_LT(on_body, 1.01 * largest);
}

// The leg runs as it is shipped, on at least 6,000 nodes: every file is there, the pressures at the hosiery levels are
// those of the documentation, and the Exodus file holds what the summary says.
TEST_F(ShippedLeg, RunsAsItIs) {
  const Outcome run = toile("run " TOILE_SOURCE_DIR "/input/pantyhose-leg.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  int nodes = 0;
  ASSERT_EQ(std::sscanf(summary_line(run.out, "garment: ").c_str(), "%d nodes", &nodes), 1);
  EXPECT_GE(nodes, 6000);
  for (const char* file : {"results.exo", "history.h5", "restart.h5", "pressure-curve.csv", "pressure-levels.csv",
                           "pressure.dat", "pressure.gp"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
  const std::string csv = read("out/pressure-levels.csv");
  const std::vector<std::pair<std::string, double>> expected = {{"B", 0.97}, {"B1", 0.62}, {"C", 0.43},
                                                                {"D", 0.41}, {"F", 0.34},  {"G", 0.23}};
  for (const auto& [level, kpa] : expected) {
    const std::vector<double> row = level_row(csv, level);
    ASSERT_GT(row.size(), 1u) << csv;
    EXPECT_NEAR(row[1], kpa, 0.02) << level;
  }
  expect_written_field_is_the_summary(run.out);
}

}  // namespace
}  // namespace toile::test
