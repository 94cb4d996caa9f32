#include "evaluation.hpp"

namespace toile::material::test {
namespace {

enum Strain { log_strain, engineering, green };
enum Modulus { tangent, secant };

const std::vector<double> wale = {0.0001, 0.1672, -2.225, 21.199, -62.05, 61.746};  // pantyhose fabric

double modulus_at(double e) {
  double sum = 0.0;
  for (int i = 5; i >= 0; --i) sum = sum * e + wale[i];
  return sum;
}

/// Fibre stress by the meaning of each reading: E e, or the integral of E (Simpson's rule, exact to rounding here).
double fibre_stress(double e, int modulus) {
  if (modulus == secant) return modulus_at(e) * e;
  const int n = 4000;
  double sum = modulus_at(0.0) + modulus_at(e);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * modulus_at(e * i / n);
  return sum * e / (3.0 * n);
}

std::vector<double> reading(int strain, int modulus) {
  const LawV1& rebar = law("rebar");
  return with(rebar, with(rebar, values("rebar", "pantyhose"), "strain", strain), "modulus", modulus);
}

/// What the wale fibre alone adds to S11 at a wale stretch.
double fibre_S11(const std::vector<double>& params, double stretch) {
  const State C = {stretch * stretch, 1.0, 0.0};
  return evaluate(law("rebar"), params, C).S[0] -
         evaluate(law("neo-hookean"), values("neo-hookean", "pantyhose"), C).S[0];
}

/// Fibre strain and the factor from its stress to S11: 2 de/dC11.
std::pair<double, double> strain_of(double l, int strain) {
  if (strain == log_strain) return {std::log(l), 1.0 / (l * l)};
  if (strain == engineering) return {l - 1.0, 1.0 / l};
  return {0.5 * (l * l - 1.0), 1.0};
}

// Each reading of the modulus polynomial gives the fibre stress that it stands for.
TEST(Rebar, readings) {
  for (int strain : {log_strain, engineering, green})
    for (int modulus : {tangent, secant})
      for (double l : {1.05, 1.2, 1.5, 1.7}) {
        const auto [e, factor] = strain_of(l, strain);
        const double stress = fibre_stress(e, modulus);
        EXPECT_GT(std::abs(stress), 1e-5);
        EXPECT_NEAR(fibre_S11(reading(strain, modulus), l), stress * factor, 1e-12 * (1.0 + std::abs(stress)))
            << strain << modulus << " " << l;
      }
}

// Beyond the calibrated range the fibre stress continues on its tangent at the end, and the status says so.
TEST(Rebar, linear_beyond_calibrated_range) {
  for (int strain : {log_strain, engineering, green})
    for (int modulus : {tangent, secant}) {
      const auto params = reading(strain, modulus);
      const auto stretch = [&](double e) {
        return strain == log_strain ? std::exp(e) : strain == engineering ? 1.0 + e : std::sqrt(1.0 + 2.0 * e);
      };
      const auto stress = [&](double e) {
        const double l = stretch(e);
        return fibre_S11(params, l) / strain_of(l, strain).second;
      };
      const double end = fibre_stress(1.0, modulus), h = 1e-4;
      const double slope = (fibre_stress(1.0 + h, modulus) - fibre_stress(1.0 - h, modulus)) / (2.0 * h);
      EXPECT_NEAR(stress(1.0), end, 1e-11 * end);
      for (double e : {1.001, 1.1, 1.2, 1.4}) EXPECT_NEAR(stress(e), end + slope * (e - 1.0), 1e-5 * end);
      const auto status = [&](double e) {
        return evaluate(law("rebar"), params, {stretch(e) * stretch(e), 1.0, 0.0}).status;
      };
      EXPECT_EQ(status(0.999), point_ok);
      EXPECT_EQ(status(1.001), point_extrapolated);
    }
}

// A shortened fibre carries nothing; with "fibres in compression" it carries its modulus at zero strain, extrapolated.
TEST(Rebar, fibres_in_compression) {
  const LawV1& rebar = law("rebar");
  const auto off = reading(log_strain, tangent), on = with(rebar, off, "fibres in compression", 1.0);
  for (double l : {0.6, 0.8, 0.95}) {
    EXPECT_EQ(fibre_S11(off, l), 0.0);
    EXPECT_NEAR(fibre_S11(on, l), wale[0] * std::log(l) / (l * l), 1e-16);
    EXPECT_EQ(evaluate(rebar, off, {l * l, 1.0, 0.0}).status, point_ok);
    EXPECT_EQ(evaluate(rebar, on, {l * l, 1.0, 0.0}).status, point_extrapolated);
  }
}

// The course fibre has its own coefficients: exchanged coefficients are the fabric turned by a right angle.
TEST(Rebar, course_is_the_other_axis) {
  auto params = values("rebar", "pantyhose"), turned = params;
  for (int i = 0; i < 6; ++i) std::swap(turned[1 + i], turned[7 + i]);
  for (const State& C : random_states(10, 0.8, 2.5, 4)) {
    const Point p = evaluate(law("rebar"), params, C), q = evaluate(law("rebar"), turned, {C[1], C[0], C[2]});
    EXPECT_NEAR(q.W, p.W, 1e-14 * (1.0 + p.W));
    EXPECT_NEAR(q.S[0], p.S[1], 1e-14 * (1.0 + std::abs(p.S[1])));
    EXPECT_NE(evaluate(law("rebar"), turned, C).W, p.W);
  }
}

}  // namespace
}  // namespace toile::material::test
