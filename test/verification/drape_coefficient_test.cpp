// Fabrics on Cusick's drapemeter, scenes input/benchmarks/drape-cotton.xml and drape-silk.xml: in the bands that are
// measured of their kind, independent of the mesh, and exact where closed forms are.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "toile/run/shadow.hpp"
#include "toile/solve/fields.hpp"
#include "verification/plane_scene.hpp"
#include "verification/print.hpp"
#include "verification/wrinkles.hpp"

namespace toile::test {
namespace {

using Teuchos::ParameterList;

constexpr double gravity = 9.80665e-9;  // N/mm^2 a g/m^2

/// In the units of the Kawabata testers.
struct Cloth {
  double bending = 0.3;   ///< B, gf cm^2/cm
  double shear = 2.0;     ///< G, gf/(cm degree)
  double weight = 200.0;  ///< g/m^2
  double tension = 10.0;  ///< K of warp and weft, N/mm

  double bending_stiffness() const { return bending * 0.0980665; }  // N mm
};

/// The scene of the cotton with another cloth, and elements of another size, mm.
ParameterList drapemeter(const Cloth& cloth, double size) {
  ParameterList scene = changeable_scene("benchmarks/drape-cotton.xml");
  const double thickness = std::sqrt(12.0 * cloth.bending_stiffness() / cloth.tension);
  const double modulus = cloth.tension / thickness, gf_per_cm_degree = 9.80665e-4 * 180.0 / M_PI;  // N/mm
  scene.sublist("Materials")
      .sublist("cloth")
      .set("thickness", thickness)
      .set("warp", modulus)
      .set("weft", modulus)
      .set("shear", cloth.shear * gf_per_cm_degree / thickness);
  scene.sublist("Loads").sublist("weight").set("area density", cloth.weight);
  scene.sublist("Panels")
      .sublist("fabric")
      .set("element size", size)
      .sublist("Shell")
      .set("shear modulus", 0.5 * modulus);
  return scene;
}

struct Drape {
  run::DrapeReading reading;
  double potential = 0.0;  ///< of fabric and weight, N mm
};

/// Potential of the weight in the last state, N mm.
double height_energy(const PlaneRun& run, double weight) {
  const mesh::Mesh& mesh = run.scene->garment().mesh;
  double moment = 0.0;  // mm^3
  for (const mesh::Block& block : mesh.blocks)
    for (int e = 0; e < block.size(); ++e) {
      double height = 0.0;
      for (int i = 0; i < block.nodes_per_element; ++i)
        height += run.states.back().position[block.connectivity[block.nodes_per_element * e + i]].z();
      moment += mesh::pattern_area(mesh, block, static_cast<size_t>(e)) * height / block.nodes_per_element;
    }
  return weight * gravity * moment;
}

/// Of a state that is an equilibrium without damping, and stable.
Drape hang(const PlaneRun& run, double weight, const std::string& title) {
  const solve::StepReport& last = run.reports.back();
  EXPECT_TRUE(last.undamped) << title;
  EXPECT_EQ(last.negative_pivots, 0) << title;
  Drape drape;
  drape.reading = run::read_drape(*run.scene, solve::compute_fields(run.scene->problem(), run.states.back()).position);
  drape.potential = last.energy.strain + height_energy(run, weight);
  print(
      "%-52s drape coefficient %.3f, %d folds, potential %.4f N mm, %.1f %% of the strain energy in hourglass modes\n",
      title.c_str(), drape.reading.coefficient, drape.reading.folds, drape.potential,
      100.0 * last.energy.stabilisation / last.energy.strain);
  return drape;
}

Drape hang(const Cloth& cloth, double size, const std::string& title) {
  return hang(run(drapemeter(cloth, size)), cloth.weight, title);
}

// The shipped cotton and silk lie in the bands that are measured of stiff cottons and of silks, in a few folds.
TEST(DrapeCoefficient, IsThatOfTheKindOfFabric) {
  const Drape cotton = hang(run_shipped("benchmarks/drape-cotton.xml"), 200.0, "stiff cotton, 6 mm");
  EXPECT_GT(cotton.reading.coefficient, 0.6);
  EXPECT_LT(cotton.reading.coefficient, 0.8);
  const Drape silk = hang(run_shipped("benchmarks/drape-silk.xml"), 60.0, "soft silk, 5 mm");
  EXPECT_GT(silk.reading.coefficient, 0.2);
  EXPECT_LT(silk.reading.coefficient, 0.4);
  for (const Drape& drape : {cotton, silk}) {
    EXPECT_GE(drape.reading.folds, 3);
    EXPECT_LE(drape.reading.folds, 8);
  }
}

/// The same with the rim held level at places at equal angles while the weight is put on, and then let go.
ParameterList let_go(ParameterList scene, int places) {
  Teuchos::Array<std::string> held;
  for (int k = 0; k < places; ++k) {
    const double angle = 2.0 * M_PI * k / places;
    char place[64];
    std::snprintf(place, sizeof place, "fabric@(%.3f %.3f)", 150.0 * std::cos(angle), 150.0 * std::sin(angle));
    held.push_back(place);
  }
  scene.sublist("Supports").sublist("lift").set("on", held).set("hold", std::string("z"));
  ParameterList& settle = scene.sublist("Stages").sublist("let go");
  settle.set("type", std::string("settle")).set("release", Teuchos::Array<std::string>(1, "lift"));
  settle.sublist("Damping");
  return scene;
}

// Stiff cotton whose rim is held level at six places, and then let go, comes to the folds that it has without.
TEST(DrapeCoefficient, OfStiffCottonDoesNotDependOnHowItCameToHang) {
  const Cloth cotton;
  const Drape expected = hang(cotton, 8.0, "stiff cotton, 8 mm");
  const Drape found =
      hang(run(let_go(drapemeter(cotton, 8.0), 6)), cotton.weight, "stiff cotton, 8 mm, let go at 6 places");
  EXPECT_NEAR(found.reading.coefficient, expected.reading.coefficient, 2e-6);
  EXPECT_NEAR(found.potential, expected.potential, 2e-6);
  EXPECT_EQ(found.reading.folds, expected.reading.folds);
}

// Elements of 10 mm, twice as long as the finer ones, raise the coefficient of cotton by less than 0.03.
TEST(DrapeCoefficient, DependsLittleOnTheMesh) {
  const Cloth cotton;
  const double coarse = hang(cotton, 10.0, "stiff cotton, 10 mm").reading.coefficient;
  const double fine = hang(cotton, 5.0, "stiff cotton, 5 mm").reading.coefficient;
  EXPECT_NEAR(coarse, fine, 0.03);
  EXPECT_GT(coarse, fine);
}

// The stiffer a fabric bends, the greater its coefficient; one that does not bend stays flat, and has 1 but for the
// facets of its rim.
TEST(DrapeCoefficient, RisesWithTheBendingStiffnessToOne) {
  double before = 0.0;
  for (const double bending : {0.05, 0.1, 0.3, 1.0, 10.0}) {
    Cloth cloth;
    cloth.bending = bending;
    char title[64];
    std::snprintf(title, sizeof title, "B = %g gf cm^2/cm, 10 mm", bending);
    const double coefficient = hang(cloth, 10.0, title).reading.coefficient;
    EXPECT_GT(coefficient, before + 0.02);
    before = coefficient;
  }
  Cloth board;
  board.bending = 3000.0;
  const Drape flat = hang(board, 10.0, "board, 10 mm");
  EXPECT_NEAR(flat.reading.coefficient, 1.0, 0.002);
  EXPECT_EQ(flat.reading.folds, 0);
}

/// Deflection of the rim of a plate of bending stiffness D, clamped at the radius a, free at b, under the load q:
/// w = q r^4/(64 D) + c1 + c2 ln r + c3 r^2 + c4 r^2 ln r, with c4 from the shear force, which vanishes at b.
double rim_deflection(double q, double D, double nu, double a, double b) {
  const double q4 = q / (64.0 * D), c4 = -q * b * b / (8.0 * D);
  const auto slope = [&](double r) { return 4.0 * q4 * r * r * r + c4 * r * (2.0 * std::log(r) + 1.0); };
  const auto curvature = [&](double r) { return 12.0 * q4 * r * r + c4 * (2.0 * std::log(r) + 3.0); };
  // w'(a) = 0 and w''(b) + nu w'(b)/b = 0, of which c2 ln r and c3 r^2 give the columns.
  const double moment = curvature(b) + nu * slope(b) / b;
  const double m11 = 1.0 / a, m12 = 2.0 * a, m21 = (nu - 1.0) / (b * b), m22 = 2.0 * (1.0 + nu);
  const double det = m11 * m22 - m12 * m21;
  const double c2 = (-slope(a) * m22 + moment * m12) / det, c3 = (-moment * m11 + slope(a) * m21) / det;
  const auto rest = [&](double r) {
    return q4 * std::pow(r, 4) + c2 * std::log(r) + c3 * r * r + c4 * r * r * std::log(r);
  };
  return rest(b) - rest(a);
}

// A ring that hardly bends has the deflection of plate theory, and stays round.
TEST(DrapeCoefficient, OfASlightlyBentRingIsThatOfAPlate) {
  constexpr double weight = 200.0, modulus = 1e5, nu = 0.3, thickness = 0.4;
  double before = NAN;
  for (const double size : {12.0, 6.0}) {
    ParameterList scene = changeable_scene("benchmarks/drape-cotton.xml");
    scene.sublist("Materials").set("cloth", ParameterList());
    scene.sublist("Materials")
        .sublist("cloth")
        .set("type", std::string("isotropic-elastic"))
        .set("Young's modulus", modulus)
        .set("Poisson's ratio", nu)
        .set("thickness", thickness);
    ParameterList& fabric = scene.sublist("Panels").sublist("fabric");
    fabric.set("element size", size).remove("Imperfection");
    fabric.sublist("Shell").remove("shear modulus");
    scene.sublist("Stages").sublist("hang").remove("Damping");
    scene.sublist("Stages").sublist("hang").set("first step", 1.0).set("largest step", 1.0);
    const PlaneRun plate = run(scene);
    const std::vector<int>& rim = plate.edge("fabric.back rim");
    double mean = 0.0;
    for (const int node : rim) mean -= plate.displacement(node).z() / static_cast<double>(rim.size());
    const double stiffness = modulus * std::pow(thickness, 3) / (12.0 * (1.0 - nu * nu));
    const double expected = rim_deflection(weight * gravity, stiffness, nu, 90.0, 150.0);
    const double error = mean / expected - 1.0;
    print("plate, %2.0f mm: deflection of the rim %.6f mm (%.6f, %+.2f %%)\n", size, mean, expected, 100.0 * error);
    if (size < 12.0) {
      EXPECT_LT(std::abs(error), 6e-4);
      EXPECT_LT(std::abs(error), std::abs(before));
    }
    before = error;
  }
}

}  // namespace
}  // namespace toile::test
