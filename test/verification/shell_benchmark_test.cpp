// Shells of Sze, Liu and Lo (2004): the scenes of input/benchmarks against the published tables (S4R elements on the
// same meshes).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/print.hpp"
#include "verification/ranks.hpp"
#include "verification/shell_scene.hpp"

namespace toile::test {
namespace {

using testing::HasSubstr;

/// One displacement of a benchmark: a component of a point of the scene, times a sign, is a column of the table.
struct Curve {
  const char* point;
  int component;
  double sign;
  const char* column;
  double tolerance;  ///< of the largest displacement of the curve
};

struct Benchmark {
  const char* scene;
  const char* table;
  const char* load_column;
  std::vector<Curve> curves;
  bool takes_minutes = false;
};

void PrintTo(const Benchmark& b, std::ostream* out) {
  *out << b.scene;
}

class ShellBenchmark : public testing::TestWithParam<Benchmark> {};

// A shipped benchmark scene has the displacements of the published table at every load of the table, in the steps that
// the scene asks for and without a cut-back.
TEST_P(ShellBenchmark, FollowsThePublishedCurve) {
  const Benchmark& b = GetParam();
  if (b.takes_minutes && !on_one_rank()) GTEST_SKIP() << "measured on one rank";
  const auto table = read_table(std::string("shell/") + b.table);
  const PointHistory history = follow_points(shipped_scene(std::string("benchmarks/") + b.scene + ".xml"));
  EXPECT_EQ(history.statistics.cut_backs, 0);
  EXPECT_EQ(history.reports.back().negative_pivots, 0);
  for (const Curve& curve : b.curves) {
    const std::vector<double>& expected = table.at(curve.column);
    const double scale = std::abs(*std::max_element(expected.begin(), expected.end(),
                                                    [](double x, double y) { return std::abs(x) < std::abs(y); }));
    double worst = 0.0, last = 0.0;
    for (size_t k = 0; k < expected.size(); ++k) {
      const size_t step = history.step_at(table.at(b.load_column)[k]);
      const double found = curve.sign * history.displacement.at(curve.point)[step][curve.component];
      last = (found - expected[k]) / scale;
      worst = std::max(worst, std::abs(last));
      EXPECT_NEAR(found, expected[k], curve.tolerance * scale)
          << curve.column << " at load " << table.at(b.load_column)[k];
    }
    print("%-18s %-16s  error at the end %6.2f %%, largest %5.2f %% of the largest displacement\n", b.scene,
          curve.column, 100.0 * last, 100.0 * worst);
  }
  print("%-18s %d steps, %d Newton iterations, %.1f a step\n", b.scene, history.statistics.steps,
        history.statistics.newton_iterations,
        static_cast<double>(history.statistics.newton_iterations) / history.statistics.steps);
}

INSTANTIATE_TEST_SUITE_P(
    SzeLiuLo, ShellBenchmark,
    testing::Values(Benchmark{"cantilever-shear",
                              "3.1_cantilever_shear.csv",
                              "P/Pmax",
                              {{"tip", 0, -1.0, "minus_Utip", 0.0006}, {"tip", 2, 1.0, "Wtip", 0.0003}}},
                    Benchmark{"cantilever-moment",
                              "3.2_cantilever_moment.csv",
                              "M/Mmax",
                              {{"tip", 0, -1.0, "minus_Utip_exact", 0.002}, {"tip", 2, 1.0, "Wtip_exact", 0.0035}}},
                    Benchmark{"slit-annulus",
                              "3.3_slit_annular_plate.csv",
                              "P/Pmax",
                              {{"A", 2, 1.0, "W_A", 0.008}, {"B", 2, 1.0, "W_B", 0.0065}}},
                    Benchmark{"hemisphere",
                              "3.4_hemisphere_hole.csv",
                              "P/Pmax",
                              {{"A", 1, 1.0, "V_A", 0.0006}, {"B", 0, -1.0, "minus_U_B", 0.0015}}},
                    Benchmark{"pinched-cylinder",
                              "3.6_pinched_cylinder_diaphragm.csv",
                              "P/Pmax",
                              {{"A", 2, -1.0, "minus_W_A", 0.03}, {"B", 0, 1.0, "U_B", 0.03}},
                              true}),
    [](const auto& instance) {
      std::string name = instance.param.scene;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

// The cantilever of 3.1 has the tip displacement of the inextensible elastica, -u = 3.28941 and w = 6.69964.
TEST(ShellBenchmark, CantileverIsAnElastica) {
  const PointHistory history = follow_points(shipped_scene("benchmarks/cantilever-shear.xml"));
  const solve::Vec3& tip = history.displacement.at("tip").back();
  EXPECT_NEAR(-tip.x(), 3.28941, 0.0025 * 3.28941);
  EXPECT_NEAR(tip.z(), 6.69964, 0.0005 * 6.69964);
}

/// Distance of a point from a polyline in the plane of two coordinates.
double distance(double x, double y, const std::vector<double>& xs, const std::vector<double>& ys) {
  double least = 1e9;
  for (size_t k = 0; k + 1 < xs.size(); ++k) {
    const double dx = xs[k + 1] - xs[k], dy = ys[k + 1] - ys[k], length = dx * dx + dy * dy;
    const double t = length > 0.0 ? std::clamp(((x - xs[k]) * dx + (y - ys[k]) * dy) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, std::hypot(x - xs[k] - t * dx, y - ys[k] - t * dy));
  }
  return least;
}

// The hinged roof snaps through and back: arc length continuation passes both limit points of the load and both turns
// of the displacement, on the published curve; no step is recorded beyond the full load, which LOCA oversteps.
TEST(ShellBenchmark, HingedRoofSnapsBackOnThePublishedCurve) {
  const auto table = read_table("shell/3.8d_hinged_roof_h6.35_iso.csv");
  const PointHistory history = follow_points(shipped_scene("benchmarks/hinged-roof.xml"));
  constexpr double load_range = 0.2, deflection_range = 25.0;  // of the part that snaps
  std::vector<double> loads, deflections;
  for (size_t k = 0; k < history.load.size(); ++k) {
    loads.push_back(history.load[k] / load_range);
    deflections.push_back(-history.displacement.at("C")[k].z() / deflection_range);
  }
  double worst = 0.0;
  for (size_t k = 0; k < table.at("P/Pmax").size() && table.at("P/Pmax")[k] < 1.0; ++k)
    worst = std::max(worst, distance(table.at("P/Pmax")[k] / load_range, table.at("minus_W_C")[k] / deflection_range,
                                     loads, deflections));
  EXPECT_LT(worst, 0.01);
  EXPECT_EQ(history.reports.back().negative_pivots, 0);
  std::string notes;
  for (const std::string& note : history.notes) notes += note + "\n";
  int limits = 0, unstable = 0;
  for (const solve::StepReport& report : history.reports) {
    limits += report.critical == solve::CriticalPoint::limit;
    unstable += report.negative_pivots > 0;
    EXPECT_LE(report.load, 1.0 + 1e-12);
  }
  EXPECT_EQ(limits, 2) << notes;
  EXPECT_GT(unstable, 5);
  EXPECT_THAT(notes, HasSubstr("a limit point was passed"));
  print(
      "hinged-roof        largest distance from the published curve %.2f %% of its size, %d limit points, %d steps, "
      "%d Newton iterations\n",
      100.0 * worst, limits, history.statistics.steps, history.statistics.newton_iterations);
}

}  // namespace
}  // namespace toile::test
