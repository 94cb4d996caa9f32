#include "toile/material/response.hpp"

#include "evaluation.hpp"

namespace toile::material::test {
namespace {

// The plain response of a law gives the law's own numbers, to the last bit.
TEST(Response, plain_is_the_law) {
  for (const Case& test : cases()) {
    const PlainResponse response(*test.law);
    EXPECT_EQ(response.n_params(), test.law->n_params);
    for (const State& C : random_states(5, 0.7, 2.0, 31)) {
      const Point p = evaluate(*test.law, test.params, C);
      const Point q = evaluate(response, test.params, C);
      EXPECT_EQ(q.W, p.W);
      EXPECT_EQ(q.S, p.S);
      EXPECT_EQ(q.D, p.D);
      EXPECT_EQ(q.thickness_stretch, p.thickness_stretch);
      EXPECT_EQ(q.status, p.status);
      EXPECT_EQ(q.bad, p.bad);
    }
  }
}

// The natural shear modulus is that of the undeformed fabric: 2 C10 of neo-Hookean and rebar, 0.0303 MPa of the hosiery
// set of itskov.
TEST(Response, natural_shear_modulus) {
  const auto modulus = [](const char* name) {
    return PlainResponse(law(name)).natural_shear_modulus(values(name, "pantyhose").data());
  };
  EXPECT_NEAR(modulus("neo-hookean"), 2.0 * 8.4667e-3, 1e-15);
  EXPECT_NEAR(modulus("rebar"), 2.0 * 8.4667e-3, 1e-15);
  EXPECT_NEAR(modulus("itskov"), 0.0303, 5e-5);
}

// A material answers by the law that it names.
TEST(Response, of_a_material) {
  const Material material(law("neo-hookean"), {0.5});
  const Material copy = material;  // NOLINT(performance-unnecessary-copy-initialization): what is tested
  EXPECT_EQ(&copy.response(), &material.response());
  EXPECT_NEAR(material.response().natural_shear_modulus(material.params().data()), 1.0, 1e-14);
}

}  // namespace
}  // namespace toile::material::test
