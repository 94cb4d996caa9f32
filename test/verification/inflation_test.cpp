#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/print.hpp"
#include "verification/shell_scene.hpp"

namespace toile::test {
namespace {

// The clamped circular membrane under follower pressure rises to the exact height at every pressure of the table.
TEST(Inflation, CircularMembraneRisesAsTheTable) {
  const auto table = read_table("plane_stress/circular_membrane_nh.csv");
  const PointHistory history = follow_points(shipped_scene("benchmarks/inflated-membrane.xml"));
  constexpr double radius = 100.0;  // mm
  const std::vector<double>& pressures = table.at("P");
  double worst = 0.0;
  for (size_t k = 0; k < pressures.size(); ++k) {
    const double expected = radius * table.at("h_over_a")[k];
    size_t step = history.load.size();
    for (size_t i = 0; i < history.load.size(); ++i)
      if (history.reports[i].undamped && std::abs(history.load[i] - pressures[k] / pressures.back()) < 1e-9) step = i;
    ASSERT_LT(step, history.load.size()) << "no final state at " << pressures[k];
    const double height = history.displacement.at("pole")[step].z();
    worst = std::max(worst, std::abs(height / expected - 1.0));
    EXPECT_NEAR(height, expected, 0.0005 * expected) << pressures[k];
  }
  print("inflated membrane: largest error of the pole's height %.3f %%\n", 100.0 * worst);
}

}  // namespace
}  // namespace toile::test
