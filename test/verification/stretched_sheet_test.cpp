// Wrinkles of a stretched, clamped sheet that appear and vanish again: the scene of input/benchmarks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "toile/solve/fields.hpp"
#include "verification/print.hpp"
#include "verification/shell_scene.hpp"
#include "verification/wrinkles.hpp"

namespace toile::test {
namespace {

constexpr double width = 140.0, thickness = 0.14, mu = 1.0;  // mm, mm, MPa
constexpr double flat = 0.05 * thickness;                    // five times the imperfection

std::vector<double> heights(const PlaneRun& sheet) {
  std::vector<double> all;
  for (size_t k = 0; k < sheet.reports.size(); ++k) all.push_back(largest_height(sheet, k));
  return all;
}

void print_work(const PlaneRun& sheet) {
  print("%zu steps, %d cut-backs, %d Newton iterations, no damping\n", sheet.reports.size(), cut_backs(sheet),
        newton_iterations(sheet));
}

/// Column of the unwrinkled reference at a ratio of length to width and a strain.
double reference(double ratio, double strain, const std::string& column) {
  const auto table = read_table("plane_stress/stretched_sheet_nh.csv");
  for (size_t k = 0; k < table.at("strain").size(); ++k)
    if (table.at("L_over_W")[k] == ratio && table.at("strain")[k] == strain) return table.at(column)[k];
  throw std::runtime_error("no such row");
}

/// The shipped scene, run once.
class StretchedSheet : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shipped_ = std::make_unique<PlaneRun>(run(shipped_scene("benchmarks/stretched-sheet.xml")));
  }
  static void TearDownTestSuite() { shipped_.reset(); }
  static const PlaneRun& shipped() { return *shipped_; }

 private:
  static std::unique_ptr<PlaneRun> shipped_;
};
std::unique_ptr<PlaneRun> StretchedSheet::shipped_;

// With L/W = 2 wrinkles higher than the sheet is thick appear, rise to one maximum, fall and are gone before 40 %;
// every state on the way is stable.
TEST_F(StretchedSheet, WrinklesRiseFallAndVanish) {
  const PlaneRun& sheet = shipped();
  const std::vector<double> height = heights(sheet);
  const auto top = std::max_element(height.begin(), height.end());
  const auto onset = std::find_if(height.begin(), height.end(), [](double h) { return h > flat; });
  const auto gone = std::find_if(top, height.end(), [](double h) { return h < flat; });
  EXPECT_GT(onset - height.begin(), 1);
  EXPECT_GT(*top, thickness);
  EXPECT_TRUE(std::is_sorted(onset, top));
  EXPECT_TRUE(std::is_sorted(top, gone, std::greater<>()));
  EXPECT_TRUE(gone != height.end() && std::all_of(gone, height.end(), [](double h) { return h < flat; }));
  for (size_t k = 0; k < height.size(); ++k) EXPECT_LE(sheet.reports[k].negative_pivots, height[k] > flat ? 1 : 0);
  const auto load = [&](auto at) { return sheet.reports[static_cast<size_t>(at - height.begin())].load; };
  print("L/W = 2: wrinkles from a strain of %.3f, highest %.3f mm (%.1f thicknesses) at %.3f, gone at %.3f\n",
        load(onset), *top, *top / thickness, load(top), load(gone));
  print_work(sheet);
}

// Where the sheet is flat again, force and transverse stress are those of the unwrinkled plane-stress solution, and the
// middle of the sheet is where it is compressed most.
TEST_F(StretchedSheet, FlatStateIsThePlaneStressSolution) {
  const PlaneRun& sheet = shipped();
  constexpr double strain = 0.4;
  const double force = sheet.reaction("plane of symmetry", sheet.last()).x() / (mu * width * thickness);
  const double expected_force = reference(2.0, strain, "force_over_mu_W_t");
  EXPECT_NEAR(force, expected_force, 0.005 * expected_force);
  const mesh::Mesh& mesh = sheet.scene->garment().mesh;
  const auto fields = solve::compute_fields(sheet.scene->problem(), sheet.states.back());
  const auto minor = std::find_if(fields.element[0].begin(), fields.element[0].end(),
                                  [](const solve::NamedField& f) { return f.name == "cauchy_minor"; });
  const mesh::Block& block = mesh.blocks[0];
  double least = 0.0, least_at = 0.0;
  for (int e = 0; e < block.size(); ++e) {
    mesh::Vec2 centre = mesh::Vec2::Zero();
    for (int i = 0; i < 4; ++i) centre += 0.25 * mesh.pattern[static_cast<size_t>(block.connectivity[4 * e + i])];
    if (std::abs(centre.y() - 0.5 * width) > 2.0 || centre.x() < 0.2 * width) continue;
    if (minor->values[static_cast<size_t>(e)] < least) {
      least = minor->values[static_cast<size_t>(e)];
      least_at = centre.x();
    }
  }
  const double expected = mu * reference(2.0, strain, "min_midline_sigma_yy");
  EXPECT_NEAR(least, expected, 0.05 * std::abs(expected));
  EXPECT_GT(least_at, 0.95 * width);
  print(
      "L/W = 2, strain 0.4: force %+.2f %%, transverse stress %+.1f %% off the plane-stress solution, least at %.2f of "
      "the length\n",
      100.0 * (force / expected_force - 1.0), 100.0 * (least / expected - 1.0), least_at / (2.0 * width));
}

/// Root mean square of the heights in the plane of symmetry, [step].
std::vector<double> mean_heights(const PlaneRun& sheet) {
  std::vector<double> all;
  for (size_t k = 0; k < sheet.reports.size(); ++k) all.push_back(profile(sheet, k, 0, width).root_mean_square());
  return all;
}

/// Linear interpolation of a value of the steps at a load.
double at_load(const PlaneRun& sheet, const std::vector<double>& value, double load) {
  size_t k = 1;
  while (k + 1 < value.size() && sheet.reports[k].load < load) ++k;
  const double before = sheet.reports[k - 1].load, after = sheet.reports[k].load;
  return value[k - 1] + (value[k] - value[k - 1]) * (load - before) / (after - before);
}

/// Largest relative difference of the mean heights to the shipped scene's, where its wrinkles are well developed.
double difference(const PlaneRun& sheet, const PlaneRun& shipped) {
  const std::vector<double> expected = mean_heights(shipped), height = heights(shipped);
  const std::vector<double> found = mean_heights(sheet);
  double worst = 0.0;
  int compared = 0;
  for (size_t k = 0; k < height.size(); ++k) {
    if (height[k] < 1.5 * thickness) continue;
    ++compared;
    worst = std::max(worst, std::abs(at_load(sheet, found, shipped.reports[k].load) / expected[k] - 1.0));
  }
  EXPECT_GT(compared, 5);
  return worst;
}

// The sheet chooses its wrinkles, not the imperfection: five half-waves across the width, a third of those that form,
// lead to the same heights at every strain.
TEST_F(StretchedSheet, WrinklesDoNotDependOnTheImperfection) {
  Teuchos::ParameterList scene = changeable_scene("benchmarks/stretched-sheet.xml");
  Teuchos::ParameterList& imperfection = scene.sublist("Panels").sublist("sheet").sublist("Imperfection");
  imperfection.set("type", "waves");
  imperfection.set("half-waves", reals({1.0, 5.0}));
  const double worst = difference(run(scene), shipped());
  EXPECT_LT(worst, 0.02);
  print("imperfection of five half-waves: mean heights differ by %.2f %% at most\n", 100.0 * worst);
}

// An imperfection of a fifth of the thickness pins the wrinkles, which otherwise can drift across the sheet: every
// state is stable then, and the heights are the same.
TEST_F(StretchedSheet, PinnedWrinklesAreStable) {
  Teuchos::ParameterList scene = changeable_scene("benchmarks/stretched-sheet.xml");
  Teuchos::ParameterList& imperfection = scene.sublist("Panels").sublist("sheet").sublist("Imperfection");
  imperfection.set("amplitude", 0.2 * thickness);
  const PlaneRun sheet = run(scene);
  for (const solve::StepReport& r : sheet.reports) EXPECT_EQ(r.negative_pivots, 0) << "load " << r.load;
  const double worst = difference(sheet, shipped());
  EXPECT_LT(worst, 0.05);
  print("imperfection of a fifth of the thickness: every state is stable, mean heights differ by %.2f %% at most\n",
        100.0 * worst);
  print_work(sheet);
}

// With L/W = 1.5 there are no wrinkles above a strain of 30 % (here: none below either).
TEST_F(StretchedSheet, ShortSheetDoesNotWrinkle) {
  Teuchos::ParameterList scene = changeable_scene("benchmarks/stretched-sheet.xml");
  constexpr double half_length = 0.75 * width;
  scene.sublist("Panels").sublist("sheet").set("width", half_length);
  scene.sublist("Panels").sublist("sheet").set("elements across", 24);
  scene.sublist("Supports").sublist("plane of symmetry").set("move by", reals({half_length, 0.0, 0.0}));
  const PlaneRun sheet = run(scene);
  const std::vector<double> height = heights(sheet);
  EXPECT_LT(*std::max_element(height.begin(), height.end()), flat);
  EXPECT_GT(sheet.reports.back().load, 0.3);
  for (const solve::StepReport& r : sheet.reports) EXPECT_EQ(r.negative_pivots, 0) << "load " << r.load;
  print("L/W = 1.5, strain up to 0.4: largest displacement out of the plane %.4f mm (%.3f thicknesses)\n",
        *std::max_element(height.begin(), height.end()), *std::max_element(height.begin(), height.end()) / thickness);
  print_work(sheet);
}

}  // namespace
}  // namespace toile::test
