// A partly wrinkled strip in bending, scene input/benchmarks/bent-strip.xml, against the closed form of Stein and
// Hedgepeth, NASA TN D-813 (1961).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/plane_scene.hpp"
#include "verification/print.hpp"
#include "verification/wrinkles.hpp"

namespace toile::test {
namespace {

constexpr double pull = 0.02, height = 50.0, length = 20.0;  // N, mm, mm
constexpr double stretching_stiffness = 100.0;               // E t, N/mm

/// What is changed of the shipped scene.
struct Strip {
  double moment = 0.4;  ///< over P h
  int rows = 32;
  double residual = 1e-4;
  double step = 0.5;  ///< largest one of the load
};

struct Bend {
  double slack;      ///< share of the height, b/h
  double curvature;  ///< E t h^2 kappa/(2 P)
  double pulled;     ///< reaction at the plane of symmetry over P
};

Bend bend(const Strip& strip) {
  Teuchos::ParameterList scene = changeable_scene("benchmarks/bent-strip.xml");
  for (const char* panel : {"strip", "plate"}) scene.sublist("Panels").sublist(panel).set("elements along", strip.rows);
  scene.sublist("Panels").sublist("strip").set("elements across", strip.rows * 13 / 32);
  scene.sublist("Materials").sublist("foil").set("residual stiffness", strip.residual);
  scene.sublist("Loads").sublist("top").set("force", reals({pull * (0.5 + strip.moment), 0.0, 0.0}));
  scene.sublist("Loads").sublist("bottom").set("force", reals({pull * (0.5 - strip.moment), 0.0, 0.0}));
  scene.sublist("Stages").sublist("bend").set("first step", std::min(0.1, strip.step)).set("largest step", strip.step);
  const PlaneRun run = test::run(scene);
  const mesh::Mesh& mesh = run.scene->garment().mesh;
  const double top = run.displacement(mesh.edges.at("strip.right").back()).x();
  const double bottom = run.displacement(mesh.edges.at("strip.right").front()).x();
  EXPECT_EQ(run.reports.back().negative_pivots, 0);
  return {-bottom / (top - bottom), stretching_stiffness * height * (top - bottom) / length / (2.0 * pull),
          -run.reaction("middle", run.last()).x() / pull};
}

double exact_slack(double moment) {
  return 3.0 * moment - 0.5;
}
double exact_curvature(double moment) {
  return 4.0 / 9.0 / ((1.0 - 2.0 * moment) * (1.0 - 2.0 * moment));
}

class BentStrip : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Moments, BentStrip, testing::Values(0.3, 0.4));

// Curvature and slack share of the strip are those of the closed form, the more exactly the finer the mesh: the
// curvature with second order from the first to the last of four meshes, between which the error depends on where in a
// row of elements the strip begins to be slack.
TEST_P(BentStrip, IsTheClosedForm) {
  const double moment = GetParam();
  ASSERT_NEAR(exact_curvature(0.3), 2.7778, 5e-5);
  ASSERT_NEAR(exact_curvature(0.4), 11.111, 5e-4);
  double first = 0.0, last = 0.0;
  for (const int rows : {8, 16, 32, 64}) {
    Strip strip;
    strip.moment = moment;
    strip.rows = rows;
    const Bend found = bend(strip);
    last = found.curvature / exact_curvature(moment) - 1.0;
    if (rows == 8) first = last;
    print("M/(P h) = %.1f, %2d rows: b/h %.4f (%.2f), E t h^2 kappa/(2 P) %.4f (%.4f), error %.3f %%\n", moment, rows,
          found.slack, exact_slack(moment), found.curvature, exact_curvature(moment), 100.0 * last);
    if (rows < 32) continue;
    EXPECT_NEAR(found.slack, exact_slack(moment), 0.0015);
    EXPECT_LT(std::abs(last), 0.006);
    EXPECT_NEAR(found.pulled, 1.0, 1e-6);
  }
  const double rate = std::log2(first / last) / 3.0;
  print("M/(P h) = %.1f: rate from 8 to 64 rows %.2f\n", moment, rate);
  EXPECT_GT(rate, moment < 0.35 ? 1.9 : 1.4);
}

// The final state depends neither on the steps of the load nor on the residual stiffness, though the curvature follows
// the balance of forces eightfold: what the residual stiffness takes from the last step on is gone at its end.
TEST(BentStripPath, DoesNotDependOnItsPath) {
  const double expected = bend({}).curvature;
  for (const double step : {0.05, 1.0}) {
    Strip strip;
    strip.step = step;
    const double found = bend(strip).curvature;
    print("largest step %.2f: curvature differs by %.4f %%\n", step, 100.0 * (found / expected - 1.0));
    EXPECT_NEAR(found, expected, 1e-3 * expected);
  }
  Strip strip;
  strip.residual = 1e-3;
  const double found = bend(strip).curvature;
  print("residual stiffness 1e-3: curvature differs by %.4f %%\n", 100.0 * (found / expected - 1.0));
  EXPECT_NEAR(found, expected, 3e-3 * expected);
}

}  // namespace
}  // namespace toile::test
