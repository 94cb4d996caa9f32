#include "plain_fad.hpp"

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
  for (const Case& test : cases()) {
    const std::string name = test.law->name;
    if (name == "hencky") expect_plain<hencky::Law>(test);
    if (name == "isotropic-elastic") expect_plain<isotropic_elastic::Law>(test);
    if (name == "itskov") expect_plain<itskov::Law>(test);
    if (name == "neo-hookean") expect_plain<neo_hookean::Law>(test);
    if (name == "rebar") expect_plain<rebar::Law>(test);
  }
}

}  // namespace
}  // namespace toile::material::test
