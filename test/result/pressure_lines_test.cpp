#include "toile/result/pressure_lines.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "support.hpp"

namespace toile::result::test {
namespace {

constexpr int around = 24;
constexpr double first_height = 100.0;
constexpr double height = 300.0;

double cone_radius(double z) {
  return 30.0 + 0.1 * z;
}
double cone_pressure(double z) {
  return 1e-3 * (2.0 - 0.004 * z);
}
/// Length of a regular polygon around the axis.
double polygon(double radius) {
  return 2.0 * around * radius * std::sin(M_PI / around);
}

/// A cone with a pressure that falls linearly with height; tension 0.06 N/mm, one element compressed.
struct Cone {
  mesh::Mesh mesh = tube(cone_radius, first_height, height, around, 15);
  GarmentFields fields;

  Cone() {
    fields.mesh = &mesh;
    fields.position = mesh.placed;
    for (const mesh::Vec3& node : mesh.placed) {
      fields.pressure.push_back(cone_pressure(node.z()));
    }
    fields.hoop_tension.assign(static_cast<std::size_t>(mesh.elements()), 0.06);
    fields.smallest_stress.assign(static_cast<std::size_t>(mesh.elements()), 0.02);
    fields.smallest_stress[3] = -0.01;
  }
};

void expect_exact(const LevelRow& row, double z) {
  EXPECT_NEAR(row.girth, polygon(cone_radius(z)), 1e-10) << z;
  EXPECT_NEAR(row.radius, polygon(cone_radius(z)) / (2.0 * M_PI), 1e-11) << z;
  EXPECT_NEAR(row.pressure_mean, cone_pressure(z), 1e-15) << z;
  EXPECT_NEAR(row.pressure_min, cone_pressure(z), 1e-15) << z;
  EXPECT_NEAR(row.pressure_max, cone_pressure(z), 1e-15) << z;
  EXPECT_NEAR(row.hoop_tension, 0.06, 1e-15) << z;
  EXPECT_NEAR(row.laplace, 0.06 / row.radius, 1e-15) << z;
  EXPECT_NEAR(row.turn, 1.0, 1e-12) << z;
}

// A cone with linear pressure has exact values at any height: inside elements, on a row of nodes and at the upper end.
TEST(PressureLines, ConeIsExact) {
  const Cone cone;
  const std::vector<LevelRow> rows =
      levels(cone.fields, Axis(), {{"inside", 107.3}, {"row", 120.0}, {"another row", 260.0}, {"end", 400.0}});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].name, "row");
  for (const LevelRow& row : rows) {
    expect_exact(row, row.height);
  }
  EXPECT_EQ(rows[0].smallest_stress, -0.01);
  EXPECT_EQ(rows[2].smallest_stress, 0.02);
}

// Heights are measured along any axis from its point, whatever the length of the direction.
TEST(PressureLines, AxisMayPointAnywhere) {
  Cone cone;
  for (mesh::Vec3& node : cone.fields.position) {
    node = mesh::Vec3(node.z() + 5.0, node.x(), node.y());
  }
  const Axis axis{mesh::Vec3(25.0, 3.0, 4.0), mesh::Vec3(2.0, 0.0, 0.0)};
  expect_exact(levels(cone.fields, axis, {{"x", 150.0}}).front(), 170.0);
}

// Pressure that varies around the section is averaged by length, with its extremes.
TEST(PressureLines, AveragesAroundTheSection) {
  Cone cone;
  for (std::size_t i = 0; i < cone.fields.pressure.size(); ++i) {
    const mesh::Vec3& x = cone.fields.position[i];
    cone.fields.pressure[i] = 1e-3 * (1.0 + x.x() / std::hypot(x.x(), x.y()));
  }
  const LevelRow row = levels(cone.fields, Axis(), {{"B", 120.0}}).front();
  EXPECT_NEAR(row.pressure_mean, 1e-3, 1e-15);
  EXPECT_NEAR(row.pressure_min, 0.0, 1e-15);
  EXPECT_NEAR(row.pressure_max, 2e-3, 1e-15);
}

// A level beside the garment is a row without values, not a number that looks like a result.
TEST(PressureLines, LevelOutsideTheGarmentHasNoValues) {
  const Cone cone;
  const LevelRow row = levels(cone.fields, Axis(), {{"G", 400.5}}).front();
  EXPECT_EQ(row.girth, 0.0);
  EXPECT_TRUE(std::isnan(row.pressure_mean));
  EXPECT_TRUE(std::isnan(row.laplace));
  EXPECT_TRUE(std::isnan(row.smallest_stress));
}

// The curve runs from end to end through exact values.
TEST(PressureLines, CurveCoversTheGarment) {
  const Cone cone;
  const std::vector<LevelRow> rows = pressure_curve(cone.fields, Axis(), 31);
  ASSERT_EQ(rows.size(), 31U);
  EXPECT_NEAR(rows.front().height, 100.0, 1e-3);
  EXPECT_NEAR(rows.back().height, 400.0, 1e-3);
  for (const LevelRow& row : rows) {
    expect_exact(row, row.height);
  }
}

// Where an end is uneven the section does not close, and its mean would mislead: the curve leaves it out.
TEST(PressureLines, CurveLeavesOutOpenSections) {
  Cone cone;
  for (mesh::Vec3& node : cone.fields.position) {
    node.z() += 0.2 * node.x();
  }
  const double rise = 0.2 * cone_radius(100.0);
  const std::vector<LevelRow> rows = pressure_curve(cone.fields, Axis(), 61);
  EXPECT_THAT(rows.size(), ::testing::AllOf(::testing::Gt(50U), ::testing::Lt(61U)));
  for (const LevelRow& row : rows) {
    EXPECT_GT(row.height, 100.0 + rise - 1e-9);
    EXPECT_NEAR(row.turn, 1.0, 1e-6);
  }
}

// The table states units in its header and gives pressures in kPa and mmHg; a missing value is an empty cell.
TEST(PressureLines, WritesCsv) {
  const TemporaryFolder folder;
  const Cone cone;
  write_pressure_csv(folder.file("levels.csv"), levels(cone.fields, Axis(), {{"B", 250.0}, {"G", 500.0}}));
  std::ifstream text(folder.file("levels.csv"));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line,
            "level,height [mm],mean pressure [kPa],mean pressure [mmHg],smallest pressure [kPa],"
            "smallest pressure [mmHg],largest pressure [kPa],largest pressure [mmHg],Laplace T/r [kPa],"
            "Laplace T/r [mmHg],girth [mm],mean radius [mm],hoop tension T [N/mm],smallest principal stress [MPa],"
            "at a support");
  std::getline(text, line);
  EXPECT_THAT(line, ::testing::StartsWith("B,250,1,7.50062,1,7.50062,1,7.50062,1.094"));
  EXPECT_THAT(line, ::testing::EndsWith(",0.06,0.02,0"));
  std::getline(text, line);
  EXPECT_EQ(line, "G,500,,,,,,,,,0,,,,0");
  EXPECT_FALSE(std::getline(text, line));
}

// The plot shows the curve in kPa, Laplace's estimate beside it and a named marker at each level on the garment.
TEST(PressureLines, PlotMarksTheLevels) {
  const Cone cone;
  const Plot plot = pressure_plot("cone", pressure_curve(cone.fields, Axis(), 11),
                                  levels(cone.fields, Axis(), {{"B", 250.0}, {"G", 500.0}}));
  ASSERT_EQ(plot.series.size(), 3U);
  EXPECT_EQ(plot.series[0].x.size(), 11U);
  EXPECT_NEAR(plot.series[0].y[0], 1e3 * cone_pressure(100.0), 1e-5);
  EXPECT_NEAR(plot.series[1].y[5], 1e3 * 0.06 / (polygon(cone_radius(250.0)) / (2.0 * M_PI)), 1e-9);
  EXPECT_THAT(plot.series[2].labels, ::testing::ElementsAre("B"));
  EXPECT_NEAR(plot.series[2].y[0], 1.0, 1e-12);
  EXPECT_NEAR(plot.second_axis->factor, 7.50062, 1e-9);
}

// Where a support ends, the rows are marked and the plot leaves their pressure out, but not Laplace's estimate.
TEST(PressureLines, MarksSectionsAtSupports) {
  Cone cone;
  cone.fields.at_support.assign(static_cast<std::size_t>(cone.mesh.elements()), false);
  std::fill_n(cone.fields.at_support.begin(), around, true);  // the lowest row, 100 to 120 mm
  const std::vector<LevelRow> rows = levels(cone.fields, Axis(), {{"in", 110.0}, {"out", 130.0}});
  EXPECT_TRUE(rows[0].at_support);
  EXPECT_FALSE(rows[1].at_support);
  const Plot plot = pressure_plot("cone", pressure_curve(cone.fields, Axis(), 31), {});
  EXPECT_TRUE(std::isnan(plot.series[0].y[1]));
  EXPECT_TRUE(std::isfinite(plot.series[0].y[5]));
  EXPECT_TRUE(std::isfinite(plot.series[1].y[1]));
}

// A table that cannot be written is reported with path and reason.
TEST(PressureLines, ReportsAnUnwritableTable) {
  const TemporaryFolder folder;
  const std::string path = folder.file("missing/levels.csv");
  EXPECT_EQ(input_error([&] { write_pressure_csv(path, {}); }),
            "cannot write the table '" + path + "': No such file or directory");
}

}  // namespace
}  // namespace toile::result::test
