#include <gtest/gtest.h>

#include <cmath>

#include "verification/plane_scene.hpp"

namespace toile::test {
namespace {

class TensileScene : public testing::TestWithParam<std::pair<const char*, double>> {};

// The tensile scenes that come with the program reach stretch 1.4, and their pantyhose strips have the reference's
// forces at every stretch of the reference.
TEST_P(TensileScene, ReachesItsEndWithTheForcesOfTheReference) {
  const auto [direction, wale] = GetParam();
  const std::string file = std::string(TOILE_SOURCE_DIR "/input/tensile-") + direction + ".xml";
  const PlaneRun result = run(base::read_xml(file, scene::scene_spec()));
  EXPECT_DOUBLE_EQ(result.reports.back().load, 1.0);
  EXPECT_TRUE(result.reports.back().undamped);
  EXPECT_EQ(result.reports.back().negative_pivots, 0);
  int compared = 0;
  for (const PlaneCase& row : plane_cases("strips")) {
    if (row["wale"] != wale || row.material == "neo-hookean") continue;
    const std::string clamp = row.material == "rebar" ? "pantyhose rebar clamp" : "pantyhose Itskov clamp";
    for (size_t step = 0; step < result.reports.size(); ++step) {
      if (std::abs(1.0 + 0.4 * result.reports[step].load - row["stretch"]) > 1e-9) continue;
      EXPECT_NEAR(result.reaction(clamp, step).y(), row["Fx"], 1e-3 * row["Fx"]) << clamp << " at " << row["stretch"];
      ++compared;
    }
  }
  EXPECT_EQ(compared, 2 * 5 + 2);  // five stretches of two models; the last one also as the stage's final state
}

INSTANTIATE_TEST_SUITE_P(Directions, TensileScene,
                         testing::Values(std::pair("wale", 0.0), std::pair("course", 90.0), std::pair("bias", 45.0)));

}  // namespace
}  // namespace toile::test
