#include "toile/material/law.hpp"

#include "evaluation.hpp"

namespace toile::material::test {
namespace {

/// What an author writes at least, with every function of an energy: the neo-hookean energy in disguise.
struct Disguised {
  static constexpr const char* name = "disguised";
  static constexpr const char* text = "a test";
  static constexpr std::array<ParamInfo, 2> info = {
      {{"C10", "MPa", "modulus", 1.0, 0.0, infinity, 1}, {"two", "", "an exponent", 2.0, 0.0, 3.0, 0}}};

  template <class T, class P>
  static T energy(const PlaneC<T>& c, const Params<P>& p) {
    const T stretch = sqrt(c.C11);
    const T root = power(c.C22, 0.5);
    const T first = where(less(stretch, T(1.2)), power(stretch, p[1]), stretch * stretch);
    const T third = c.cof11() * c.cof22() - c.cof12() * c.cof12();  // = C33, because det C = 1
    const T logarithm = along<P>(c.C33, [](const auto& x) { return log(x); });
    return p[0] * (first + power(root, 2.0) + third * c.cof33() * c.C33 - 3.0) + p[0] * (log(c.det) + logarithm);
  }
};

// A law without sets and conditions works: its functions, choices of branch and univariate parts are differentiated
// right.
TEST(Law, author_functions) {
  static constexpr LawV1 disguised = make_law<Disguised>();
  EXPECT_EQ(disguised.n_sets, 0);
  for (const State& C : random_states(20, 0.8, 1.8, 6)) {
    const Point p = evaluate(disguised, {0.3, 2.0}, C), q = evaluate(law("neo-hookean"), {0.3}, C);
    EXPECT_NEAR(p.W, q.W, 1e-13);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(p.S[a], q.S[a], 1e-12);
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(p.D[k], q.D[k], 1e-11);
  }
}

// The range of each parameter is a condition of every law.
TEST(Law, check_without_own_conditions) {
  static constexpr LawV1 disguised = make_law<Disguised>();
  std::array<char, 128> message = {};
  const double good[] = {1.0, 3.0}, bad[] = {1.0, 4.0};
  EXPECT_EQ(disguised.check(nullptr, good, message.data(), 128), 0);
  EXPECT_EQ(disguised.check(nullptr, bad, message.data(), 128), 2);
  EXPECT_STREQ(message.data(), "4 is out of range: allowed is >= 0 and <= 3");
}

}  // namespace
}  // namespace toile::material::test
