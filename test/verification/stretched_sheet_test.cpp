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

void expect_stable(const PlaneRun& sheet) {
  for (const solve::StepReport& r : sheet.reports) EXPECT_EQ(r.negative_pivots, 0) << "load " << r.load;
}

void print_work(const PlaneRun& sheet) {
  print("%zu steps, %d cut-backs, %d Newton iterations, all states stable, no damping\n", sheet.reports.size(),
        cut_backs(sheet), newton_iterations(sheet));
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
  expect_stable(sheet);
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

/// Linear interpolation of the height at a load.
double height_at(const PlaneRun& sheet, const std::vector<double>& height, double load) {
  size_t k = 1;
  while (k + 1 < height.size() && sheet.reports[k].load < load) ++k;
  const double before = sheet.reports[k - 1].load, after = sheet.reports[k].load;
  return height[k - 1] + (height[k] - height[k - 1]) * (load - before) / (after - before);
}

/// Mean distance of the zeros in the middle half of the width in the plane of symmetry, mm.
double half_wave(const PlaneRun& sheet, size_t step, double half_length) {
  const Profile middle = profile(sheet, step, 0, half_length);
  const double centre = 0.5 * (middle.at.front() + middle.at.back());
  std::vector<double> inner;
  for (const double y : middle.zeros())
    if (std::abs(y - centre) < 0.25 * width) inner.push_back(y);
  return (inner.back() - inner.front()) / static_cast<double>(inner.size() - 1);
}

// The sheet chooses its wrinkles, not the imperfection: five half-waves across the width, a third of those that form,
// lead to the heights and wavelengths of the random offsets, on a mesh with two thirds of the elements.
TEST_F(StretchedSheet, WrinklesDoNotDependOnTheImperfection) {
  Teuchos::ParameterList scene = changeable_scene("benchmarks/stretched-sheet.xml");
  Teuchos::ParameterList& panel = scene.sublist("Panels").sublist("sheet");
  panel.set("elements across", 24);
  panel.set("elements along", 72);
  panel.sublist("Imperfection").set("type", "waves");
  panel.sublist("Imperfection").set("half-waves", reals({1.0, 5.0}));
  const PlaneRun waves = run(scene);
  const std::vector<double> expected = heights(shipped()), height = heights(waves);
  double worst = 0.0;
  int compared = 0;
  for (size_t k = 0; k < height.size(); ++k) {
    const double at_load = height_at(shipped(), expected, waves.reports[k].load);
    if (at_load < thickness) continue;
    ++compared;
    worst = std::max(worst, std::abs(height[k] / at_load - 1.0));
    EXPECT_NEAR(height[k], at_load, 0.05 * at_load) << waves.reports[k].load;
  }
  EXPECT_GT(compared, 5);
  const size_t peak = static_cast<size_t>(std::max_element(height.begin(), height.end()) - height.begin());
  size_t same_load = 0;
  while (shipped().reports[same_load].load < waves.reports[peak].load - 1e-3) ++same_load;
  const double found = half_wave(waves, peak, width), wanted = half_wave(shipped(), same_load, width);
  EXPECT_NEAR(found, wanted, 0.05 * wanted);
  print("another imperfection: heights differ by %.1f %% at most, half-wave %.2f mm (random: %.2f mm)\n", 100.0 * worst,
        found, wanted);
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
  expect_stable(sheet);
  print("L/W = 1.5, strain up to 0.4: largest displacement out of the plane %.4f mm (%.3f thicknesses)\n",
        *std::max_element(height.begin(), height.end()), *std::max_element(height.begin(), height.end()) / thickness);
  print_work(sheet);
}

}  // namespace
}  // namespace toile::test
