// Strong ellipticity of the plane-stress energies: closed forms, the energy itself, and what is known of the fabrics.
#include "toile/material/ellipticity.hpp"

#include <memory>

#include "evaluation.hpp"
#include "toile/material/law.hpp"
#include "toile/material/relaxed_response.hpp"

namespace toile::material::test {
namespace {

using Tensor = std::array<std::array<double, 2>, 2>;

State cauchy_green(const Tensor& F) {
  return {F[0][0] * F[0][0] + F[1][0] * F[1][0], F[0][1] * F[0][1] + F[1][1] * F[1][1],
          F[0][0] * F[0][1] + F[1][0] * F[1][1]};
}

Ellipticity at(const LawV1& law, const std::vector<double>& params, const State& C) {
  const Point p = evaluate(law, params, C);
  return ellipticity(C, p.S, p.D);
}

bool in_tension(const std::array<double, 3>& S) {
  return S[0] >= 0.0 && S[1] >= 0.0 && S[0] * S[1] >= S[2] * S[2];
}

/// Stretch of the other axis under uniaxial tension: the stress across vanishes.
double free_stretch(const LawV1& law, const std::vector<double>& params, double stretch, bool along_course) {
  double low = 0.1, high = 1.5;
  while (high - low > 1e-13) {
    const double middle = 0.5 * (low + high), c = middle * middle, q = stretch * stretch;
    const Point p = evaluate(law, params, along_course ? State{c, q, 0.0} : State{q, c, 0.0});
    (p.S[along_course ? 0 : 1] > 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

// Neo-Hookean fabric, W = C10 (|F|^2 + 1/J^2 - 3) with J = det F: Q = 2 C10 (1 + 3 m (x) m / J^2) with m = F^-T n, so
// the smallest eigenvalue is 2 C10 in every state and the largest 2 C10 (1 + 3/(J^2 smallest principal stretch^2)).
TEST(Ellipticity, neo_hookean_closed_form) {
  for (const State& C : random_states(50, 0.5, 2.0, 3)) {
    const Ellipticity e = at(law("neo-hookean"), {0.4}, C);
    const double mean = 0.5 * (C[0] + C[1]), radius = std::hypot(0.5 * (C[0] - C[1]), C[2]);
    const double largest = 0.8 * (1.0 + 3.0 / ((mean + radius) * (mean - radius) * (mean - radius)));
    EXPECT_NEAR(e.smallest, 0.8, 1e-11 * largest);
    EXPECT_NEAR(e.largest, largest, 3e-3 * largest);
    EXPECT_FALSE(e.is_lost());
  }
}

// Saint Venant-Kirchhoff fabric of stretch l in every direction: with B = Y/(1 - nu^2) the eigenvalues are, for every
// n, B (2 l^2 - 1 - nu)/2 across n and B ((3 + nu) l^2 - 1 - nu)/2 along it; the first turns negative at l^2 = (1 +
// nu)/2.
TEST(Ellipticity, saint_venant_kirchhoff_closed_form) {
  const double young = 0.08, nu = 0.3, B = young / (1.0 - nu * nu), critical = std::sqrt(0.5 * (1.0 + nu));
  for (const double l : {0.7, critical - 1e-6, critical + 1e-6, 0.9, 1.0, 1.5}) {
    const Ellipticity e = at(law("isotropic-elastic"), {young, nu}, {l * l, l * l, 0.0});
    EXPECT_NEAR(e.smallest, 0.5 * B * (2.0 * l * l - 1.0 - nu), 1e-15) << l;
    EXPECT_NEAR(e.largest, 0.5 * B * ((3.0 + nu) * l * l - 1.0 - nu), 1e-15) << l;
    EXPECT_EQ(e.is_lost(), l < critical) << l;
  }
}

/// Smallest second derivative of W(F + t m (x) n) by t over unit vectors m and n, from energies alone.
double brute_force(const LawV1& law, const std::vector<double>& params, const Tensor& F) {
  constexpr int angles = 90;
  constexpr double t = 2e-3;
  const double step = std::acos(-1.0) / angles, W = evaluate(law, params, cauchy_green(F)).W;
  double smallest = infinity;
  for (int i = 0; i < angles; ++i)
    for (int k = 0; k < angles; ++k) {
      const std::array<double, 2> n = {std::cos(i * step), std::sin(i * step)},
                                  m = {std::cos(k * step), std::sin(k * step)};
      double second = -2.0 * W;
      for (const double sign : {-t, t}) {
        Tensor G = F;
        for (int r = 0; r < 2; ++r)
          for (int c = 0; c < 2; ++c) G[r][c] += sign * m[r] * n[c];
        second += evaluate(law, params, cauchy_green(G)).W;
      }
      smallest = std::min(smallest, second / (t * t));
    }
  return smallest;
}

// The smallest eigenvalue is the smallest curvature of the energy along rank-one changes of F, for every material.
TEST(Ellipticity, agrees_with_the_energy) {
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> stretch(0.8, 1.5), shear(-1.5, 1.5);
  int lost = 0;
  for (const Case& c : cases())
    for (int i = 0; i < 6; ++i) {
      const Tensor F = {{{stretch(generator), shear(generator)}, {0.0, stretch(generator)}}};
      const Ellipticity e = at(*c.law, c.params, cauchy_green(F));
      EXPECT_NEAR(e.smallest, brute_force(*c.law, c.params, F), 3e-3 * e.largest) << c.name << " " << i;
      lost += e.is_lost();
    }
  EXPECT_GT(lost, 0);
}

// The direction is where the smallest eigenvalue is: along it the energy has that curvature.
TEST(Ellipticity, direction_has_the_smallest_curvature) {
  const std::vector<double> params = values("itskov", "pantyhose");
  const Tensor F = {{{0.95, 2.3}, {0.0, 1.15}}};
  const Ellipticity e = at(law("itskov"), params, cauchy_green(F));
  EXPECT_NEAR(std::hypot(e.direction[0], e.direction[1]), 1.0, 1e-14);
  constexpr double t = 1e-4;
  const double W = evaluate(law("itskov"), params, cauchy_green(F)).W;
  double smallest = infinity;
  for (int k = 0; k < 3600; ++k) {
    const double angle = k * std::acos(-1.0) / 3600;
    double second = -2.0 * W;
    for (const double sign : {-t, t}) {
      Tensor G = F;
      for (int c = 0; c < 2; ++c) {
        G[0][c] += sign * std::cos(angle) * e.direction[c];
        G[1][c] += sign * std::sin(angle) * e.direction[c];
      }
      second += evaluate(law("itskov"), params, cauchy_green(G)).W;
    }
    smallest = std::min(smallest, second / (t * t));
  }
  EXPECT_NEAR(smallest, e.smallest, 1e-5 * e.largest);
}

// Both published Itskov sets are polyconvex in three dimensions and lose ellipticity in plane stress in the sheared,
// compressed state F = [[0.95, 2.3], [0, 1.15]]; wherever both principal stresses are tensile they keep it.
TEST(Ellipticity, itskov_loses_it_in_sheared_compression_only) {
  for (const char* set : {"pantyhose", "t-shirt"}) {
    const std::vector<double> params = values("itskov", set);
    const State C = cauchy_green({{{0.95, 2.3}, {0.0, 1.15}}});
    EXPECT_FALSE(in_tension(evaluate(law("itskov"), params, C).S)) << set;
    EXPECT_TRUE(at(law("itskov"), params, C).is_lost()) << set;
    int tensile = 0;
    for (const State& state : random_states(5000, 0.7, 2.5, 11)) {
      const Point p = evaluate(law("itskov"), params, state);
      if (p.status == point_not_admissible || !in_tension(p.S)) continue;
      ++tensile;
      EXPECT_FALSE(ellipticity(state, p.S, p.D).is_lost()) << set;
    }
    EXPECT_GT(tensile, 500);
  }
}

// The literal hosiery law (its polynomials taken beyond their calibrated range) loses ellipticity under uniaxial
// tension along the course at a stretch near 3.4; continued linearly it keeps it up to 6.
TEST(Ellipticity, literal_rebar_law_loses_it_near_course_stretch_3_4) {
  const LawV1& rebar = law("rebar");
  const auto continued = values("rebar", "pantyhose"), literal = with(rebar, continued, "calibrated strain", 5.0);
  const auto first_loss = [&](const std::vector<double>& params) {
    for (double stretch = 1.0; stretch < 6.0; stretch += 0.01) {
      const double across = free_stretch(rebar, params, stretch, true);
      if (at(rebar, params, {across * across, stretch * stretch, 0.0}).is_lost()) return stretch;
    }
    return 6.0;
  };
  EXPECT_NEAR(first_loss(literal), 3.4, 0.1);
  EXPECT_EQ(first_loss(continued), 6.0);
}

// What is called surely elliptic is elliptic, and most states in tension are found at once.
TEST(Ellipticity, quick_condition_is_sufficient) {
  int surely = 0, tensile = 0;
  for (const Case& c : cases())
    for (const State& C : random_states(200, 0.9, 1.8, 5)) {
      const Point p = evaluate(*c.law, c.params, C);
      if (p.status == point_not_admissible) continue;
      tensile += in_tension(p.S);
      if (!is_surely_elliptic(p.S, p.D)) continue;
      ++surely;
      EXPECT_FALSE(ellipticity(C, p.S, p.D).is_lost()) << c.name;
    }
  EXPECT_GT(surely, tensile / 2);
}

// What is not a number is not called lost.
TEST(Ellipticity, not_a_number) {
  const double nan = std::nan("");
  EXPECT_FALSE(ellipticity({1.0, 1.0, 0.0}, {nan, nan, nan}, {nan, nan, nan, nan, nan, nan}).is_lost());
  EXPECT_FALSE(is_surely_elliptic({nan, nan, nan}, {nan, nan, nan, nan, nan, nan}));
}

}  // namespace
}  // namespace toile::material::test
