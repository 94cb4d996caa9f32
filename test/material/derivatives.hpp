#pragma once

#include "evaluation.hpp"

namespace toile::material::test {

/// dC of a unit step along E_b, E = (C11/2, C22/2, C12).
inline constexpr std::array<double, 3> dC_dE = {2.0, 2.0, 1.0};

inline State moved(State C, int b, double step) {
  C[b] += dC_dE[b] * step;
  return C;
}

template <std::size_t N>
double largest(const std::array<double, N>& a) {
  double result = 0.0;
  for (double value : a) result = std::max(result, std::abs(value));
  return result;
}

/// S and D against central differences of W and S, not zero.
inline void expect_derivatives(const Case& test, const State& C) {
  const Point p = evaluate(*test.law, test.params, C);
  ASSERT_EQ(p.bad, 0);
  const double h = 2e-5;
  const double tolerance = 1e-6 * std::max(largest(p.S), largest(p.D));
  EXPECT_GT(largest(p.S), 0.0);
  EXPECT_GT(largest(p.D), 0.0);
  for (int b = 0; b < 3; ++b) {
    const Point up = evaluate(*test.law, test.params, moved(C, b, h));
    const Point down = evaluate(*test.law, test.params, moved(C, b, -h));
    EXPECT_NEAR(p.S[b], (up.W - down.W) / (2.0 * h), tolerance) << test.name;
    // Both triangles of the tangent: dS_a/dE_b and dS_b/dE_a are the same stored number.
    for (int a = 0; a < 3; ++a)
      EXPECT_NEAR(p.tangent(a, b), (up.S[a] - down.S[a]) / (2.0 * h), tolerance) << test.name << a << b;
  }
}

/// dS/dp against central differences, for each parameter that is a number; zero for choices.
inline void expect_parameter_derivatives(const Case& test, const State& C) {
  const int n = test.law->n_params;
  std::vector<double> dSdp(3 * n);
  Point p;
  test.law->evaluate(test.law->context, 1, C.data(), test.params.data(), 0, &p.W, p.S.data(), nullptr,
                     &p.thickness_stretch, dSdp.data(), &p.status);
  for (int k = 0; k < n; ++k) {
    const bool is_choice = test.law->info[k].choices != nullptr;
    const double h = is_choice ? 0.0 : 1e-5 * std::max(std::abs(test.params[k]), 1e-3);
    std::vector<double> up = test.params, down = test.params;
    up[k] += h;
    down[k] -= h;
    const Point a = evaluate(*test.law, up, C), b = evaluate(*test.law, down, C);
    for (int i = 0; i < 3; ++i) {
      const double expected = is_choice ? 0.0 : (a.S[i] - b.S[i]) / (2.0 * h);
      EXPECT_NEAR(dSdp[i * n + k], expected, 2e-7 * (std::abs(expected) + largest(p.S) / std::max(h * 1e5, 1e-3)))
          << test.name << ", " << test.law->info[k].name;
    }
  }
}

}  // namespace toile::material::test
