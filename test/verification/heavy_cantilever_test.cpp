// A strip of fabric that bends under its own weight, scene input/benchmarks/cantilever-weight.xml, against the
// inextensible elastica (test/data/shell/heavy_cantilever.csv).
#include <gtest/gtest.h>

#include <cmath>

#include "verification/plane_scene.hpp"
#include "verification/print.hpp"
#include "verification/shell_scene.hpp"
#include "verification/wrinkles.hpp"

namespace toile::test {
namespace {

constexpr double length = 100.0, largest_lambda = 64.0;  // mm; of the scene at load 1

/// The line from clamp to tip, over the length.
struct Tip {
  double x, drop;
  double chord() const { return std::atan2(drop, x) * 180.0 / M_PI; }
};

/// The tip at each lambda of the table, with n elements along the strip that are half as long as wide.
std::vector<Tip> tips(const std::vector<double>& lambdas, int n, const std::string& integration) {
  Teuchos::ParameterList scene = changeable_scene("benchmarks/cantilever-weight.xml");
  Teuchos::ParameterList& strip = scene.sublist("Panels").sublist("strip");
  strip.set("elements across", n).set("elements along", n / 8).sublist("Shell").set("integration", integration);
  const PlaneRun hanging = run(scene);
  EXPECT_EQ(cut_backs(hanging), 0);
  const size_t tip = static_cast<size_t>(hanging.scene->output().points.front().node);
  std::vector<Tip> all;
  for (const double lambda : lambdas) {
    const size_t step = final_step(hanging, lambda / largest_lambda);
    EXPECT_EQ(hanging.reports[step].negative_pivots, 0) << lambda;
    const solve::Vec3& x = hanging.states[step].position[tip];
    all.push_back({x.x() / length, -x.z() / length});
  }
  return all;
}

class HeavyCantilever : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Rules, HeavyCantilever, testing::Values("full", "reduced"));

// The tip is where the elastica has it, at small and at very large deflections, and converges to there with second
// order; every state is stable.
TEST_P(HeavyCantilever, HangsAsTheElastica) {
  const auto table = read_table("shell/heavy_cantilever.csv");
  const std::vector<double>& lambdas = table.at("lambda");
  std::vector<double> before(lambdas.size(), NAN);
  for (const int n : {24, 48}) {
    const std::vector<Tip> found = tips(lambdas, n, GetParam());
    for (size_t k = 0; k < lambdas.size(); ++k) {
      const double x = table.at("x_over_L")[k], drop = table.at("drop_over_L")[k];
      const double error = std::hypot(found[k].x - x, found[k].drop - drop);
      const double rate = std::log2(before[k] / error);
      print(
          "%-7s %2d elements  lambda %2.0f  chord %.4f degrees (%.4f), tip x/L %.6f (%.6f), drop/L %.6f (%.6f), "
          "off by %.4f %% of the length  rate %.2f\n",
          GetParam(), n, lambdas[k], found[k].chord(), table.at("chord_deg")[k], found[k].x, x, found[k].drop, drop,
          100.0 * error, rate);
      before[k] = error;
      if (n == 24) continue;
      EXPECT_LT(error, 1e-4) << lambdas[k];
      if (lambdas[k] > 1.0) {  // else what is left is the strip's own stretch and shear
        EXPECT_GT(rate, 1.9) << lambdas[k];
      }
    }
  }
}

}  // namespace
}  // namespace toile::test
