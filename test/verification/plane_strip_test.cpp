#include <gtest/gtest.h>

#include <cmath>

#include "verification/plane_scene.hpp"
#include "verification/print.hpp"
#include "verification/ranks.hpp"

namespace toile::test {
namespace {

/// What the reference gives of a strip.
struct Strip {
  solve::Vec3 force;  ///< of the right clamp, N
  double width, shift;
};

Strip strip(const PlaneCase& row, const PlaneMesh& mesh) {
  const PlaneRun result = run(strip_list(row, mesh));
  const size_t middle = static_cast<size_t>(mesh.across) / 2;
  const auto& position = result.states.back().position;
  const solve::Vec3 section =
      position[result.edge("sheet.top")[middle]] - position[result.edge("sheet.bottom")[middle]];
  return {result.reaction("right", result.last()), section.y(), section.x()};
}

PlaneCase row_of(const std::string& material, double wale, double stretch) {
  for (const PlaneCase& row : plane_cases("strips"))
    if (row.material == material && row["wale"] == wale && std::abs(row["stretch"] - stretch) < 1e-9) return row;
  throw std::runtime_error("no such strip");
}

// On uniform meshes the force of a clamped strip converges to the reference with the rate 2 x 0.690 of its corners.
TEST(Strip, UniformMeshesConvergeWithTheRateOfTheCorners) {
  if (!on_one_rank()) GTEST_SKIP() << "measured on one rank";
  constexpr double rate = 2.0 * 0.690;
  const PlaneCase row = row_of("neo-hookean", 0, 1.2);
  double error[3];
  for (int level = 0; level < 3; ++level) {
    const int n = 8 << level;
    error[level] = std::abs(strip(row, {3 * n, n}).force.x() - row["Fx"]);
    print("neo-hookean, stretch 1.2, uniform %3d x %2d: error of the force %.4f %%\n", 3 * n, n,
          100.0 * error[level] / row["Fx"]);
    if (level == 0) continue;
    EXPECT_GE(std::log2(error[level - 1] / error[level]), 0.95 * rate) << n << " elements across";
  }
  EXPECT_LT(error[2], 0.001 * row["Fx"]);
}

// On a mesh graded to its corners every fabric, pulled at 0, 45 and 90 degrees to the wale, has the reference's force,
// necking and shear.
TEST(Strip, GradedMeshAgreesWithTheReferenceForEveryFabricAndDirection) {
  for (const PlaneCase& row : plane_cases("strips")) {
    if (row["stretch"] != 1.4 && row["stretch"] != 1.1) continue;
    const Strip found = strip(row, {60, 20, 2.0});
    const std::string what =
        row.material + ", wale " + std::to_string(row["wale"]) + ", stretch " + std::to_string(row["stretch"]);
    print("%-12s wale at %2g deg, stretch %g, graded 60 x 20: error of force %.4f %%, width %.4f %%\n",
          row.material.c_str(), row["wale"], row["stretch"], 100.0 * (found.force.x() / row["Fx"] - 1.0),
          100.0 * (found.width / row["width"] - 1.0));
    EXPECT_NEAR(found.force.x(), row["Fx"], 0.001 * row["Fx"]) << what;
    EXPECT_NEAR(found.force.y(), row["Fy"], 0.001 * row["Fx"]) << what;
    EXPECT_NEAR(found.width, row["width"], 0.001 * row["width"]) << what;
    EXPECT_NEAR(found.shift, row["shift"], 0.001 * row["width"]) << what;
  }
}

}  // namespace
}  // namespace toile::test
