#include <gtest/gtest.h>

#include <cmath>

#include "verification/plane_scene.hpp"
#include "verification/print.hpp"
#include "verification/ranks.hpp"

namespace toile::test {
namespace {

constexpr double grading = 1.75;  // more than 1/0.624, the corner's exponent

/// What the reference gives of Cook's membrane.
struct Cook {
  double tip_ux, tip_uy, mean_edge_uy, energy;
};

Cook cook(const PlaneCase& row, const PlaneMesh& mesh) {
  const PlaneRun result = run(cook_list(row, mesh));
  const std::vector<int>& edge = result.edge("sheet.right");
  const auto& pattern = result.scene->garment().mesh.pattern;
  double integral = 0.0;
  for (size_t k = 1; k < edge.size(); ++k) {
    const double length = (pattern[edge[k]] - pattern[edge[k - 1]]).norm();
    integral += 0.5 * length * (result.displacement(edge[k]).y() + result.displacement(edge[k - 1]).y());
  }
  const solve::Vec3 tip = result.displacement(edge.back());
  return {tip.x(), tip.y(), integral / 16.0, result.reports.back().energy.strain};
}

// On uniform meshes Cook's membrane converges to the reference with the rate 2 x 0.624 of its corner's singularity.
TEST(Cook, UniformMeshesConvergeWithTheRateOfTheCorner) {
  if (!on_one_rank()) GTEST_SKIP() << "measured on one rank";
  constexpr double rate = 2.0 * 0.624;
  const PlaneCase row = plane_cases("cook").front();
  double error[3];
  for (int level = 0; level < 3; ++level) {
    const int n = 16 << level;
    error[level] = std::abs(cook(row, {n, n}).mean_edge_uy - row["mean_edge_uy"]);
    print("neo-hookean, F = 24, uniform %2d x %2d: error of the edge's mean deflection %.4f %%\n", n, n,
          100.0 * error[level] / row["mean_edge_uy"]);
    if (level == 0) continue;
    EXPECT_GE(std::log2(error[level - 1] / error[level]), 0.95 * rate) << n << " x " << n;
  }
  EXPECT_LT(error[2], 0.01 * row["mean_edge_uy"]);
}

// On meshes graded to its corners Cook's membrane converges with the full second order of linear elements to the
// published displacements of an incompressible sheet.
TEST(Cook, GradedMeshesConvergeWithSecondOrderToThePublishedDisplacements) {
  if (!on_one_rank()) GTEST_SKIP() << "measured on one rank";
  constexpr double tip_uy = 2.4064, mean_edge_uy = 2.33543;
  const PlaneCase row = plane_cases("cook").front();
  const Cook coarse = cook(row, {24, 24, grading}), middle = cook(row, {48, 48, grading}),
             fine = cook(row, {96, 96, grading});
  EXPECT_GE(std::log2((coarse.mean_edge_uy - mean_edge_uy) / (middle.mean_edge_uy - mean_edge_uy)), 0.95 * 2.0);
  EXPECT_GE(std::log2((middle.mean_edge_uy - mean_edge_uy) / (fine.mean_edge_uy - mean_edge_uy)), 0.95 * 2.0);
  EXPECT_NEAR((4.0 * fine.tip_uy - middle.tip_uy) / 3.0, tip_uy, 2e-4 * tip_uy);
  EXPECT_NEAR((4.0 * fine.mean_edge_uy - middle.mean_edge_uy) / 3.0, mean_edge_uy, 2e-4 * mean_edge_uy);
}

// On a mesh graded to its corners every fabric bends Cook's membrane as the independent reference does.
TEST(Cook, GradedMeshAgreesWithTheReferenceForEveryFabric) {
  for (const PlaneCase& row : plane_cases("cook")) {
    const Cook found = cook(row, {96, 96, grading});
    const std::string what = row.material + ", F = " + std::to_string(row["F"]);
    print("%-12s F = %-6g graded 96 x 96: error of tip %.4f %%, edge %.4f %%, energy %.4f %%\n", row.material.c_str(),
          row["F"], 100.0 * (found.tip_uy / row["tip_uy"] - 1.0),
          100.0 * (found.mean_edge_uy / row["mean_edge_uy"] - 1.0), 100.0 * (found.energy / row["energy"] - 1.0));
    EXPECT_NEAR(found.tip_ux, row["tip_ux"], 0.003 * std::abs(row["tip_ux"])) << what;
    EXPECT_NEAR(found.tip_uy, row["tip_uy"], 0.002 * row["tip_uy"]) << what;
    EXPECT_NEAR(found.mean_edge_uy, row["mean_edge_uy"], 0.002 * row["mean_edge_uy"]) << what;
    EXPECT_NEAR(found.energy, row["energy"], 0.002 * row["energy"]) << what;
  }
}

}  // namespace
}  // namespace toile::test
