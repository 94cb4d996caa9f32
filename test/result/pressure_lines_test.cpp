#include "toile/result/pressure_lines.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

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
    // Two parts of one error of 2e-5.
    fields.pressure_errors = {{"mesh", std::vector<double>(mesh.placed.size(), 1.2e-5)},
                              {"body", std::vector<double>(mesh.placed.size(), 1.6e-5)}};
    fields.tied = tied_by_place(mesh);
    set_tension();
    fields.smallest_stress.assign(static_cast<std::size_t>(mesh.elements()), 0.02);
    fields.smallest_stress[3] = -0.01;
  }

  /// 0.06 N/mm along the sections, 0.02 N/mm across, in space: nothing of it knows the fabric's directions.
  void set_tension() {
    fields.tension.clear();
    const mesh::Block& block = mesh.blocks[0];
    for (std::size_t i = 0; i < block.connectivity.size(); i += 4) {
      const auto node = [&](std::size_t k) {
        return fields.position[static_cast<std::size_t>(block.connectivity[i + k])];
      };
      const mesh::Vec3 along = (node(1) - node(0)).normalized();
      const mesh::Vec3 normal = along.cross(node(3) - node(0)).normalized();
      const mesh::Vec3 up = normal.cross(along);
      fields.tension.emplace_back(0.06 * along * along.transpose() + 0.02 * up * up.transpose());
    }
  }

  /// A second one, moved by `step`, its numbers of nodes after those of the first.
  void add_copy(const mesh::Vec3& step) {
    const int nodes = mesh.nodes();
    mesh::Block copy = mesh.blocks[0];
    copy.name = "copy";
    for (int& node : copy.connectivity) {
      node += nodes;
    }
    mesh.blocks.push_back(copy);
    for (int n = 0; n < nodes; ++n) {
      const auto at = static_cast<std::size_t>(n);
      mesh.placed.push_back(mesh.placed[at] + step);
      mesh.pattern.push_back(mesh.pattern[at]);
      fields.position.push_back(fields.position[at] + step);
      fields.tied.push_back(fields.tied[at] + nodes);
    }
    const auto twice = [](auto& values) {
      const auto once = values;
      values.insert(values.end(), once.begin(), once.end());
    };
    twice(fields.pressure);
    for (PressureError& part : fields.pressure_errors) twice(part.values);
    twice(fields.tension);
    twice(fields.smallest_stress);
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
  EXPECT_NEAR(row.pressure_error, 2e-5, 1e-16) << z;
  EXPECT_NEAR(row.error_parts.at(1), 1.6e-5, 1e-16) << z;
  EXPECT_TRUE(row.closed) << z;
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

// A tension that changes along the garment, one value an element, is that of the section's height at any height.
TEST(PressureLines, TensionIsThatOfTheHeight) {
  Cone cone;
  const auto tension = [](double z) { return 0.06 + 1e-3 * (z - first_height); };
  for (int e = 0; e < cone.mesh.elements(); ++e) {
    double z = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
      z += 0.25 * cone.fields.position[static_cast<std::size_t>(cone.mesh.blocks[0].connectivity[4 * e + k])].z();
    cone.fields.tension[static_cast<std::size_t>(e)] *= tension(z) / 0.06;
  }
  for (const double share : {0.33, 0.4, 0.51}) {
    const double z = first_height + share * height;
    const std::vector<LevelRow> rows = levels(cone.fields, {}, {{"here", z}});
    EXPECT_NEAR(rows.front().hoop_tension, tension(z), 2e-3 * tension(z)) << z;
  }
}

// The error of a section between two rows of nodes holds what the line between them misses: at least half and at most
// three and a half times of it, where the pressure bends in one place and where it is smooth.
TEST(PressureLines, ErrorHoldsWhatTheLineBetweenRowsMisses) {
  const double spacing = height / 15;
  const double bend = first_height + 7.5 * spacing;
  const auto bent = [&](double z) { return 2e-3 - 4e-6 * std::abs(z - bend); };
  const auto smooth = [&](double z) { return 2e-3 - 1e-7 * (z - bend) * (z - bend); };
  for (const auto& pressure : {std::function<double(double)>(bent), std::function<double(double)>(smooth)}) {
    Cone cone;
    for (std::size_t n = 0; n < cone.fields.pressure.size(); ++n)
      cone.fields.pressure[n] = pressure(cone.fields.position[n].z());
    for (PressureError& part : cone.fields.pressure_errors) part.values.assign(part.values.size(), 0.0);
    for (const double share : {0.2, 0.5, 0.7}) {
      const double z = first_height + (7.0 + share) * spacing;
      const LevelRow row = levels(cone.fields, {}, {{"here", z}}).front();
      const double error = std::abs(row.pressure_mean - pressure(z));
      EXPECT_GT(row.pressure_error, 0.5 * error - 1e-15) << z;
      EXPECT_LT(row.pressure_error, 3.5 * error) << z;
    }
  }
}

// Heights are measured along any axis from its point, whatever the length of the direction.
TEST(PressureLines, AxisMayPointAnywhere) {
  Cone cone;
  for (mesh::Vec3& node : cone.fields.position) {
    node = mesh::Vec3(node.z() + 5.0, node.x(), node.y());
  }
  cone.set_tension();
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

// A level beside the garment is a row without values, not a number that looks like a result, and it is told.
TEST(PressureLines, LevelOutsideTheGarmentHasNoValues) {
  const Cone cone;
  const std::vector<LevelRow> rows = levels(cone.fields, Axis(), {{"G", 400.5}});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_FALSE(rows[0].reached());
  EXPECT_TRUE(std::isnan(rows[0].girth));
  EXPECT_TRUE(std::isnan(rows[0].pressure_mean));
  EXPECT_TRUE(std::isnan(rows[0].laplace));
  EXPECT_TRUE(std::isnan(rows[0].smallest_stress));
  EXPECT_THAT(level_warnings(cone.fields, Axis(), rows),
              ::testing::ElementsAre("level \"G\" at the height 400.5 mm does not meet the garment, which lies between "
                                     "100 and 400 mm: it has no values"));
}

// Two legs have a row each, with the girth of one; names and panels tell them apart.
TEST(PressureLines, EveryClosedSectionHasItsRow) {
  Cone cone;
  cone.add_copy({200.0, 0.0, 0.0});
  const std::vector<LevelRow> rows = levels(cone.fields, Axis(), {{"C", 250.0}});
  ASSERT_EQ(rows.size(), 2U);
  for (const LevelRow& row : rows) {
    expect_exact(row, 250.0);
  }
  EXPECT_EQ(rows[0].title(), "C (1)");
  EXPECT_EQ(rows[1].title(), "C (2)");
  EXPECT_EQ(rows[0].panels, "tube");
  EXPECT_EQ(rows[1].panels, "copy");
  const Plot plot = pressure_plot("legs", pressure_curve(cone.fields, Axis(), 11), rows);
  EXPECT_EQ(plot.series[0].title, "mean contact pressure (1)");
  EXPECT_EQ(plot.series[1].title, "mean contact pressure (2)");
}

// Layers have a row each, and their sum is what the body feels: pressure, its error, tension and Laplace's value twice,
// the girth once.
TEST(PressureLines, LayersAddUp) {
  Cone cone;
  cone.add_copy({0.0, 0.0, 0.0});
  const std::vector<LevelRow> rows = levels(cone.fields, Axis(), {{"C", 250.0}});
  ASSERT_EQ(rows.size(), 3U);
  expect_exact(rows[0], 250.0);
  expect_exact(rows[1], 250.0);
  const LevelRow& sum = rows[2];
  EXPECT_EQ(sum.title(), "C (1+2)");
  EXPECT_NEAR(sum.girth, rows[0].girth, 1e-12);
  EXPECT_NEAR(sum.pressure_mean, 2.0 * cone_pressure(250.0), 1e-15);
  EXPECT_NEAR(sum.pressure_max, 2.0 * cone_pressure(250.0), 1e-15);
  EXPECT_NEAR(sum.pressure_error, 4e-5, 1e-16);
  EXPECT_NEAR(sum.hoop_tension, 0.12, 1e-15);
  EXPECT_NEAR(sum.laplace, 2.0 * rows[0].laplace, 1e-15);
}

// A level along the seam of two panels that press differently is told with both pressures; beside the seam, and where
// they press alike, nothing is.
TEST(PressureLines, LevelAlongASeamIsTold) {
  Cone cone;
  const std::size_t nodes = cone.mesh.placed.size();
  cone.add_copy({0.0, 0.0, height});
  for (std::size_t n = 0; n < nodes; ++n)
    for (std::size_t copy = nodes; copy < 2 * nodes; ++copy) {
      const mesh::Vec3 &below = cone.fields.position[n], &above = cone.fields.position[copy];
      const bool opposite = below.z() > first_height + height - 1e-6 && above.z() < first_height + height + 1e-6 &&
                            below.head<2>().normalized().dot(above.head<2>().normalized()) > 1.0 - 1e-9;
      if (!opposite) continue;
      cone.fields.position[copy] = below;
      cone.fields.tied[copy] = cone.fields.tied[n];
    }
  const auto warnings = [&](double at) {
    return level_warnings(cone.fields, Axis(), levels(cone.fields, Axis(), {{"C", at}}));
  };
  EXPECT_THAT(warnings(first_height + height),
              ::testing::ElementsAre(::testing::HasSubstr(
                  "level \"C\" runs along the seam of panels \"tube\" and \"copy\", which press with "
                  "0.4 and 1.6 kPa there")));
  EXPECT_THAT(warnings(first_height + height + 5.0), ::testing::IsEmpty());
  std::fill(cone.fields.pressure.begin(), cone.fields.pressure.end(), 1e-3);
  EXPECT_THAT(warnings(first_height + height), ::testing::IsEmpty());
}

// A sleeve that no seam closes has an open section: a length, but no radius and no value by Laplace's law.
TEST(PressureLines, OpenSectionIsMarked) {
  Cone cone;
  cone.fields.tied.clear();
  const std::vector<LevelRow> rows = levels(cone.fields, Axis(), {{"C", 250.0}});
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_FALSE(rows[0].closed);
  EXPECT_NEAR(rows[0].girth, polygon(cone_radius(250.0)), 1e-10);
  EXPECT_NEAR(rows[0].hoop_tension, 0.06, 1e-15);
  EXPECT_TRUE(std::isnan(rows[0].laplace));
  EXPECT_TRUE(std::isnan(rows[0].radius));
  EXPECT_THAT(level_warnings(cone.fields, Axis(), rows),
              ::testing::ElementsAre(::testing::HasSubstr("does not close")));
}

// Half a cone that is held in its plane of symmetry has the values of the whole one, girth and radius included; held in
// two planes, it is open.
TEST(PressureLines, HalfClosesWithItsMirrorImage) {
  Cone cone;
  std::vector<int>& nodes = cone.mesh.blocks[0].connectivity;
  std::vector<int> half;
  decltype(cone.fields.tension) tension;
  for (std::size_t e = 0; 4 * e < nodes.size(); ++e) {
    double y = 0.0;
    for (std::size_t k = 4 * e; k < 4 * e + 4; ++k) y += cone.mesh.placed[static_cast<std::size_t>(nodes[k])].y();
    if (y < 0.0) continue;
    half.insert(half.end(), &nodes[4 * e], &nodes[4 * e] + 4);
    tension.push_back(cone.fields.tension[e]);
  }
  nodes = half;
  cone.fields.tension = tension;
  cone.fields.smallest_stress.resize(tension.size());
  cone.fields.tied.clear();
  for (const mesh::Vec3& node : cone.mesh.placed) cone.fields.mirror.push_back(std::abs(node.y()) < 1e-9 ? 0 : -1);
  const std::vector<LevelRow> rows = levels(cone.fields, Axis(), {{"C", 250.0}});
  ASSERT_EQ(rows.size(), 1U);
  expect_exact(rows[0], 250.0);
  EXPECT_TRUE(rows[0].mirrored);
  for (std::size_t n = 0; n < cone.mesh.placed.size(); ++n)
    if (cone.fields.mirror[n] == 0 && cone.mesh.placed[n].x() > 0.0) cone.fields.mirror[n] = 1;
  EXPECT_FALSE(levels(cone.fields, Axis(), {{"C", 250.0}})[0].closed);
}

// Along the axis of a bent limb, three quarters of a ring here, heights are arc lengths and sections lie across it; the
// other arm of the limb, which the plane cuts as well, is left out.
TEST(PressureLines, AxisMayBeBent) {
  constexpr double bend = 200.0, length = 1.5 * M_PI * bend;
  const auto place = [=](double arc) {
    const double on_ring = std::clamp(arc, 0.0, length), angle = on_ring / bend;
    const mesh::Vec3 direction(-std::sin(angle), 0.0, std::cos(angle));
    return AxisPlace{mesh::Vec3(bend * std::cos(angle), 0.0, bend * std::sin(angle)) + (arc - on_ring) * direction,
                     direction};
  };
  Cone cone;
  for (mesh::Vec3& node : cone.fields.position) {
    const double arc = (node.z() - first_height) / height * length;
    const mesh::Vec3 outwards = place(arc).point / bend;
    node = place(arc).point + node.x() * outwards + mesh::Vec3(0.0, node.y(), 0.0);
  }
  Axis axis;
  axis.bent = place;
  axis.length = length;
  for (int row = 1; row < 15; ++row) {  // on the rows of nodes, where the girth is that of the polygon
    const std::vector<LevelRow> rows = levels(cone.fields, axis, {{"row", length * row / 15.0}});
    ASSERT_EQ(rows.size(), 1U) << row;
    EXPECT_TRUE(rows[0].closed);
    EXPECT_NEAR(rows[0].girth, polygon(cone_radius(100.0 + 20.0 * row)), 1e-6) << row;
  }
  const std::vector<LevelRow> curve = pressure_curve(cone.fields, axis, 31);
  EXPECT_EQ(curve.size(), 31U);
  EXPECT_NEAR(curve.front().height, 0.0, 1e-3 * length);
  EXPECT_NEAR(curve.back().height, length, 1e-3 * length);
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
    EXPECT_TRUE(row.closed);
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
            "at a support,closed,error of the mean pressure [kPa],error of the mean pressure [mmHg],panels");
  std::getline(text, line);
  EXPECT_THAT(line, ::testing::StartsWith("B,250,1,7.50062,1,7.50062,1,7.50062,1.094"));
  EXPECT_THAT(line, ::testing::EndsWith(",0.06,0.02,0,1,0.02,0.1500124,tube"));
  std::getline(text, line);
  EXPECT_EQ(line, "G,500,,,,,,,,,,,,,0,0,,,");
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
