#include "derivatives.hpp"

namespace toile::material::test {
namespace {

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
    for (const State& C : random_states(4, 0.8, 3.2, 11)) expect_parameter_derivatives(test, C);
  }
}

}  // namespace
}  // namespace toile::material::test
