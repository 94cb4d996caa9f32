#include "plain_fad.hpp"

#include <map>

#include "evaluation.hpp"

namespace toile::material::test {
namespace {

template <class Law>
void expect_plain(const Case& test) {
  for (const State& C : random_states(50, 0.7, 3.2, 21)) {
    const Point p = evaluate(*test.law, test.params, C);
    const PlainHessian w = plain_energy<Law>(C.data(), test.params.data());
    const auto number = [&](const std::array<double, 3>& c) {
      return Law::energy(PlaneC<double>(c[0], c[1], c[2]), Params<double>(test.params.data(), test.params.data()));
    };
    double scale = 0.0;
    for (double d : p.D) scale = std::max(scale, std::abs(d));
    const double factor[3] = {2.0, 2.0, 1.0};
    EXPECT_NEAR(p.W, number(C), 1e-12 * scale) << test.name;
    EXPECT_NEAR(p.W, w.val().val(), 1e-12 * scale) << test.name;
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(p.S[a], factor[a] * w.dx(a).val(), 1e-12 * scale) << test.name;
      for (int b = 0; b < 3; ++b)
        EXPECT_NEAR(p.tangent(a, b), factor[a] * factor[b] * w.dx(a).dx(b), 1e-12 * scale) << test.name << a << b;
    }
  }
}

// Every registered material gives what plain nested Sacado types and plain numbers give from the same energy, to 1e-12.
TEST(Oracle, plain_nested_fad) {
  const std::map<std::string, void (*)(const Case&)> oracles = {
      {"hencky", expect_plain<hencky::Law>},
      {"isotropic-elastic", expect_plain<isotropic_elastic::Law>},
      {"itskov", expect_plain<itskov::Law>},
      {"neo-hookean", expect_plain<neo_hookean::Law>},
      {"rebar", expect_plain<rebar::Law>}};
  for (const Case& test : cases()) {
    const auto oracle = oracles.find(test.law->name);
    ASSERT_NE(oracle, oracles.end()) << test.law->name << " has no oracle: add it to this test";
    oracle->second(test);
  }
}

}  // namespace
}  // namespace toile::material::test
