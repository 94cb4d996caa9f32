#include "evaluation.hpp"

namespace toile::material::test {
namespace {

/// dC of a unit step along E_b, E = (C11/2, C22/2, C12).
constexpr std::array<double, 3> dC_dE = {2.0, 2.0, 1.0};

State moved(State C, int b, double step) {
  C[b] += dC_dE[b] * step;
  return C;
}

template <std::size_t N>
double largest(const std::array<double, N>& a) {
  double result = 0.0;
  for (double value : a) result = std::max(result, std::abs(value));
  return result;
}

void expect_derivatives(const Case& test, const State& C) {
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

// S and D are the first and second derivatives of W (central differences), symmetric and not zero, at sheared states.
TEST(Derivatives, stress_and_tangent_at_random_states) {
  for (const Case& test : cases())
    for (const State& C : random_states(40, 0.75, 2.2, 7)) expect_derivatives(test, C);
}

// The same where a fibre is slack, and where a fibre is stretched beyond its calibrated range.
TEST(Derivatives, slack_and_extrapolated_fibres) {
  const Case test = {"rebar", &law("rebar"), values("rebar", "pantyhose")};
  for (const State& C : {State{0.7, 1.9, 0.2}, State{1.9, 0.7, -0.2}, State{0.8, 0.85, 0.1}}) {
    EXPECT_EQ(evaluate(*test.law, test.params, C).status, point_ok);
    expect_derivatives(test, C);
  }
  for (const State& C : {State{8.5, 1.3, 0.4}, State{0.9, 9.0, 0.4}, State{8.0, 8.0, 1.0}}) {
    EXPECT_EQ(evaluate(*test.law, test.params, C).status, point_extrapolated);
    expect_derivatives(test, C);
  }
}

// W and S do not depend on whether the tangent is asked for.
TEST(Derivatives, without_tangent) {
  for (const Case& test : cases())
    for (const State& C : random_states(10, 0.75, 2.2, 3)) {
      const Point p = evaluate(*test.law, test.params, C);
      Point q;
      test.law->evaluate(test.law->context, 1, C.data(), test.params.data(), 0, &q.W, q.S.data(), nullptr,
                         &q.thickness_stretch, nullptr, &q.status);
      EXPECT_NEAR(q.W, p.W, 1e-14 * (1.0 + std::abs(p.W)));
      for (int a = 0; a < 3; ++a) EXPECT_NEAR(q.S[a], p.S[a], 1e-13 * (1.0 + largest(p.S))) << test.name;
    }
}

// dS/dp is the derivative of S by each parameter that is a number (central differences), and zero for choices.
TEST(Derivatives, stress_by_parameters) {
  std::vector<Case> all = cases();
  for (Case& test : all) {
    if (test.law == &law("itskov")) test.params[index_of(*test.law, "w2_3")] = 0.2;  // off the kink at w_1 + w_2 = 1
    for (const State& C : random_states(4, 0.8, 3.2, 11)) {
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
  }
}

}  // namespace
}  // namespace toile::material::test
