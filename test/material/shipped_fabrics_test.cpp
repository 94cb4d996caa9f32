#include <gmock/gmock.h>

#include "derivatives.hpp"
#include "plugins.hpp"

namespace toile::material::test {
namespace {

const LawV1& fung() {
  static const Laws::Law law = shipped_law("fung_orthotropic");
  return *law;
}
const LawV1& hgo() {
  static const Laws::Law law = shipped_law("holzapfel_gasser_ogden");
  return *law;
}

const std::vector<double> fung_values = {0.02, 1.4, 0.9, 0.3, 0.7};
/// Fibres at 30 degrees; the second set is dispersed.
const std::vector<std::vector<double>> hgo_values = {{0.03, 0.02, 0.8, 30.0, 0.0}, {0.03, 0.02, 0.8, 30.0, 0.2}};

std::vector<Case> shipped() {
  return {{"fung", &fung(), fung_values}, {"hgo", &hgo(), hgo_values[0]}, {"hgo, dispersed", &hgo(), hgo_values[1]}};
}

// The shipped fabrics have neither energy nor stress in their natural state, and a positive tangent there.
TEST(ShippedFabrics, natural_state) {
  for (const Case& fabric : shipped()) {
    const Point p = evaluate(*fabric.law, fabric.params, {1.0, 1.0, 0.0});
    EXPECT_EQ(p.W, 0.0) << fabric.name;
    EXPECT_THAT(p.S, ::testing::Each(0.0)) << fabric.name;
    for (int a = 0; a < 3; ++a) EXPECT_GT(p.tangent(a, a), 0.0) << fabric.name;
  }
}

// Stress and tangent are the derivatives of the energy (central differences), also where fibres are slack.
TEST(ShippedFabrics, derivatives) {
  for (const Case& fabric : shipped())
    for (const State& C : random_states(40, 0.8, 1.5, 5)) expect_derivatives(fabric, C);
}

// dS/dp is right for every parameter, the angle of the fibres among them.
TEST(ShippedFabrics, derivatives_by_parameters) {
  for (const Case& fabric : shipped())
    for (const State& C : random_states(10, 0.8, 1.5, 6)) expect_parameter_derivatives(fabric, C);
}

// Fung: the stress is that of the equation in equibiaxial and uniaxial strain and in shear, to rounding.
TEST(ShippedFabrics, fung_stress) {
  const double c = fung_values[0], A1 = fung_values[1], A2 = fung_values[2], A3 = fung_values[3], A4 = fung_values[4];
  for (const State& C : {State{1.44, 1.44, 0.0}, State{1.69, 0.81, 0.0}, State{1.2, 1.1, 0.4}}) {
    const double E11 = 0.5 * (C[0] - 1.0), E22 = 0.5 * (C[1] - 1.0), E12 = 0.5 * C[2];
    const double e = c * std::exp(A1 * E11 * E11 + A2 * E22 * E22 + 2.0 * A3 * E11 * E22 + A4 * E12 * E12);
    const Point p = evaluate(fung(), fung_values, C);
    EXPECT_NEAR(p.S[0], e * (A1 * E11 + A3 * E22), 1e-15);
    EXPECT_NEAR(p.S[1], e * (A3 * E11 + A2 * E22), 1e-15);
    EXPECT_NEAR(p.S[2], 0.5 * e * A4 * E12, 1e-15);
  }
}

/// S11 and S22 of the Holzapfel-Gasser-Ogden membrane without dispersion at principal stretches along wale and course.
std::array<double, 2> hgo_stress(const std::vector<double>& p, double wale, double course) {
  const double C11 = wale * wale, C22 = course * course, C33 = 1.0 / (C11 * C22), angle = p[3] * M_PI / 180.0;
  const double cc = std::cos(angle) * std::cos(angle), ss = 1.0 - cc, E = std::max(C11 * cc + C22 * ss - 1.0, 0.0);
  const double fibres = 4.0 * p[1] * E * std::exp(p[2] * E * E);  // two families, 2 k1 E exp each
  return {p[0] * (1.0 - C33 / C11) + fibres * cc, p[0] * (1.0 - C33 / C22) + fibres * ss};
}

// Holzapfel-Gasser-Ogden: equibiaxial stress, and the wale stress and free lateral contraction of uniaxial tension.
TEST(ShippedFabrics, hgo_stress) {
  const std::vector<double>& params = hgo_values[0];
  for (const double stretch : {1.1, 1.3, 1.6}) {
    const Point p = evaluate(hgo(), params, {stretch * stretch, stretch * stretch, 0.0});
    const auto expected = hgo_stress(params, stretch, stretch);
    EXPECT_NEAR(p.S[0], expected[0], 1e-13 * expected[0]);
    EXPECT_NEAR(p.S[1], expected[1], 1e-13 * expected[1]);
    EXPECT_NEAR(p.S[2], 0.0, 1e-15);
    double narrow = 0.3, wide = 1.0;  // the lateral stretch without stress, by bisection in the closed form
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (narrow + wide);
      (hgo_stress(params, stretch, middle)[1] < 0.0 ? narrow : wide) = middle;
    }
    const Point q = evaluate(hgo(), params, {stretch * stretch, narrow * narrow, 0.0});
    EXPECT_NEAR(q.S[1], 0.0, 1e-14);
    EXPECT_NEAR(q.S[0], hgo_stress(params, stretch, narrow)[0], 1e-14);
  }
}

// Fibres that are shortened carry nothing: compressed along both families the fabric is its matrix alone.
TEST(ShippedFabrics, hgo_slack_fibres) {
  const State compressed = {0.81, 0.85, 0.05};
  const Point p = evaluate(hgo(), hgo_values[0], compressed);
  const Point matrix = evaluate(law("neo-hookean"), {0.5 * hgo_values[0][0]}, compressed);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(p.S[a], matrix.S[a], 1e-16);
  EXPECT_NEAR(p.W, matrix.W, 1e-16);
}

// An exponential that overflows is refused as a state that is not admissible; it is never infinite or a silent NaN.
TEST(ShippedFabrics, overflow_is_refused) {
  const Point p = evaluate(fung(), {0.02, 50.0, 50.0, 0.0, 1.0}, {25.0, 25.0, 0.0});
  EXPECT_EQ(p.status, point_not_admissible);
  EXPECT_EQ(p.bad, 1);
  EXPECT_TRUE(std::isnan(p.W));
}

// The condition A3^2 < A1 A2 is checked, with the parameter that is wrong.
TEST(ShippedFabrics, fung_condition) {
  std::array<char, 512> message = {};
  const std::vector<double> values = {0.02, 1.0, 1.0, 1.5, 1.0};
  EXPECT_EQ(fung().check(fung().context, values.data(), message.data(), 512), 4);
  EXPECT_STREQ(message.data(), "A3^2 = 2.25 must be less than A1 A2 = 1, or Q is not positive");
}

}  // namespace
}  // namespace toile::material::test
