// Four tubes, one over the other, on a cylinder, scene input/benchmarks/layers.xml, against the closed form of a tube
// that is pulled round only: the sum of T_i/(R + (i - 1/2) t) with the present thickness.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "toile/run/pressure_report.hpp"
#include "toile/solve/fields.hpp"
#include "verification/plane_scene.hpp"
#include "verification/print.hpp"
#include "verification/wrinkles.hpp"

namespace toile::test {
namespace {

constexpr double radius = 30.0, width = 50.0 * M_PI, C10 = 0.02;  // mm, MPa

struct Tube {
  double tension = 0.0, radius = 0.0;  ///< N/mm; mm, of the mid-surface
};

/// [layer] Incompressible neo-Hookean tubes, pulled round only, of which each lies on the one before.
std::vector<Tube> exact_tubes(int layers, double thickness) {
  std::vector<Tube> all;
  double beneath = radius;
  for (int i = 0; i < layers; ++i) {
    double now = thickness, stretch = 1.0;
    for (int round = 0; round < 100; ++round) {
      stretch = 2.0 * M_PI * (beneath + 0.5 * now) / width;
      now = thickness / std::sqrt(stretch);
    }
    all.push_back({2.0 * C10 * (stretch * stretch - 1.0 / stretch) * now, beneath + 0.5 * now});
    beneath += now;
  }
  return all;
}

/// [layer] Tension over radius, kPa.
std::vector<double> exact_pressures(int layers, double thickness = 1.0) {
  std::vector<double> all;
  for (const Tube& tube : exact_tubes(layers, thickness)) all.push_back(1e3 * tube.tension / tube.radius);
  return all;
}

/// The scene with its inner layers alone.
Teuchos::ParameterList layers(int count) {
  Teuchos::ParameterList scene = changeable_scene("benchmarks/layers.xml");
  Teuchos::Array<std::string> bottoms;
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    if (i <= count) {
      bottoms.push_back("layer " + number + ".bottom");
    } else {
      scene.sublist("Panels").remove("layer " + number);
      scene.sublist("Seams").remove("side " + number);
    }
  }
  scene.sublist("Supports").sublist("lower ends").set("on", bottoms);
  return scene;
}

template <class Change>
void change_panels(Teuchos::ParameterList& scene, const Change& change) {
  Teuchos::ParameterList& panels = scene.sublist("Panels");
  for (auto panel = panels.begin(); panel != panels.end(); ++panel) change(panels.sublist(panels.name(panel)));
}

/// [layer] Mean pressure, kPa.
std::vector<double> pressures(const PlaneRun& run) {
  const solve::Fields& fields = run.session->record().fields();
  std::vector<double> all;
  for (const mesh::MeshedPanel& panel : run.scene->garment().mesh.panels) {
    double sum = 0.0;
    for (int n = panel.first; n < panel.first + panel.nodes; ++n) sum += 1e3 * fields.pressure[n] / panel.nodes;
    all.push_back(sum);
  }
  return all;
}

double sum(const std::vector<double>& all) {
  return std::accumulate(all.begin(), all.end(), 0.0);
}

// Each layer presses as a tube of its own radius and stretch, and their sum converges with second order.
TEST(Layers, PressAsTheSumOfTubes) {
  const std::vector<double> expected = exact_pressures(4);
  double before = NAN;
  for (const int around : {24, 48, 96}) {
    Teuchos::ParameterList scene = layers(4);
    change_panels(scene, [&](Teuchos::ParameterList& panel) { panel.set("elements across", around); });
    const std::vector<double> found = pressures(run(scene));
    const double error = sum(found) / sum(expected) - 1.0, rate = std::log2(std::abs(before / error));
    before = error;
    print("%2d elements around: %.4f + %.4f + %.4f + %.4f = %.4f kPa (%.4f), error %.3f %%  rate %.2f\n", around,
          found[0], found[1], found[2], found[3], sum(found), sum(expected), 100.0 * error, rate);
    if (around > 24) {
      EXPECT_GT(rate, 1.9) << around;
    }
    if (around < 96) continue;
    for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 0.002 * expected[i]) << i;
  }
}

/// At the level and at the place of the scene all layers are added up, each within the error that is told there.
void expect_sum(const Teuchos::ParameterList& scene, double expected, const std::string& title) {
  const PlaneRun done = run(scene);
  const run::Record& record = done.session->record();
  const result::LevelRow& level = record.pressure().levels.back();
  const run::PointPressure at =
      run::body_pressures(*done.scene, done.scene->output().body_points, record.fields(), record.last()).front();
  print("%s: level %.4f +- %.4f kPa, place %.4f +- %.4f kPa (%.4f), error %+.3f and %+.3f %%\n", title.c_str(),
        1e3 * level.pressure_mean, 1e3 * level.pressure_error, 1e3 * at.pressure, 1e3 * at.error, expected,
        100.0 * (1e3 * level.pressure_mean / expected - 1.0), 100.0 * (1e3 * at.pressure / expected - 1.0));
  EXPECT_NEAR(1e3 * level.pressure_mean, expected, 1e3 * level.pressure_error);
  EXPECT_NEAR(1e3 * level.laplace, expected, 0.008 * expected);
  EXPECT_NEAR(1e3 * at.pressure, expected, 1e3 * at.error);
}

// Two, three and four layers press together on free meshes as the closed form says.
TEST(Layers, AreAddedUpOnFreeMeshes) {
  for (const std::string elements : {"quadrilateral", "triangle"})
    for (int count = 2; count <= 4; ++count) {
      Teuchos::ParameterList scene = layers(count);
      change_panels(scene, [&](Teuchos::ParameterList& panel) {
        panel.remove("elements across");
        panel.remove("elements along");
        panel.set("elements", elements);
        panel.set("mesher", "free");
        panel.set("element size", 4.0);
      });
      expect_sum(scene, sum(exact_pressures(count)), std::to_string(count) + " layers, free " + elements + "s");
    }
}

// So do layers of wadding, of which the outermost lies 10 mm off the skin.
TEST(Layers, AreAddedUpHoweverThick) {
  Teuchos::ParameterList scene = layers(4);
  scene.sublist("Materials").sublist("bandage").set("thickness", 3.0);
  expect_sum(scene, sum(exact_pressures(4, 3.0)), "4 layers of 3 mm");
}

// A layer may have several panels: what lies over a front and a back lies over one thickness, not over two.
TEST(Layers, LieOverPanelsBesideEachOther) {
  Teuchos::ParameterList scene = layers(2);
  Teuchos::ParameterList &panels = scene.sublist("Panels"), &seams = scene.sublist("Seams");
  for (const char* name : {"front", "back"}) {
    panels.sublist(name) = panels.sublist("layer 1");
    panels.sublist(name).set("width", 0.5 * width);
    panels.sublist(name).set("elements across", 24);
    panels.sublist(name).sublist("Placement").set("coverage", 0.5);
  }
  panels.sublist("back").sublist("Placement").set("angle", 180.0);
  panels.remove("layer 1");
  panels.sublist("layer 2").set("over", Teuchos::Array<std::string>(base::Texts{"front", "back"}));
  seams.remove("side 1");
  seams.sublist("one").set("first", "front.right").set("second", "back.left");
  seams.sublist("other").set("first", "back.right").set("second", "front.left");
  scene.sublist("Supports")
      .sublist("lower ends")
      .set("on", Teuchos::Array<std::string>(base::Texts{"front.bottom", "back.bottom", "layer 2.bottom"}));
  expect_sum(scene, sum(exact_pressures(2)), "over two halves");
}

// Per area of the inner face layers press with the sum of their tensions over the radius of the skin.
TEST(Layers, PressTheSkinItselfOnItsArea) {
  Teuchos::ParameterList scene = layers(4);
  change_panels(scene, [](Teuchos::ParameterList& panel) { panel.set("elements across", 96); });
  scene.sublist("Contact").set("pressure area", "inner face");
  double expected = 0.0;
  for (const Tube& tube : exact_tubes(4, 1.0)) expected += 1e3 * tube.tension / radius;
  const double found = sum(pressures(run(scene)));
  print("on the skin's own area: %.4f kPa (%.4f)\n", found, expected);
  EXPECT_NEAR(found, expected, 0.002 * expected);
}

// Layers that are not told to lie over each other all lie on the skin: each presses like the first.
TEST(Layers, DifferFromTubesOnTheSkin) {
  Teuchos::ParameterList scene = layers(4);
  change_panels(scene, [](Teuchos::ParameterList& panel) {
    if (panel.isParameter("over")) panel.remove("over");
  });
  const std::vector<double> found = pressures(run(scene)), expected = exact_pressures(4);
  for (const double pressure : found) EXPECT_NEAR(pressure, expected[0], 0.005 * expected[0]);
  print("all on the skin: %.4f kPa, %+.2f %%\n", sum(found), 100.0 * (sum(found) / sum(expected) - 1.0));
}

}  // namespace
}  // namespace toile::test
