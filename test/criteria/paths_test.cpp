// First losses along the paths of tensile tests.
#include "toile/criteria/paths.hpp"

#include <cmath>

#include "fabrics.hpp"

namespace toile::criteria::test {
namespace {

Path path(const std::string& name) {
  for (const Path& one : paths())
    if (name == one.name) return one;
  throw std::runtime_error("no path " + name);
}

// The literal hosiery law loses stability near a course stretch of 3.4, in strip and in uniaxial tension.
TEST(Paths, LiteralHosieryLosesStabilityInCourse) {
  const Fabric literal = literal_form(published("rebar, pantyhose")).front();
  for (const char* name : {"strip course", "uniaxial course"}) {
    const Losses lost = losses(literal, path(name), 6.0);
    ASSERT_TRUE(lost.ellipticity && lost.convexity && lost.force) << name;
    EXPECT_NEAR(*lost.ellipticity, 3.4, 0.1) << name;
    EXPECT_NEAR(*lost.convexity, 3.4, 0.1) << name;
    EXPECT_NEAR(*lost.force, 3.4, 0.1) << name;
  }
}

// The continued hosiery law keeps its stability on every path up to a stretch of 6, and says where it is continued:
// from e = ln l = 1 on.
TEST(Paths, ContinuedHosieryIsStable) {
  for (const Path& one : paths()) {
    const Losses lost = losses(published("rebar, pantyhose"), one, 6.0);
    EXPECT_FALSE(lost.ellipticity || lost.convexity || lost.force) << one.name;
    ASSERT_TRUE(lost.range) << one.name;
    EXPECT_NEAR(*lost.range, std::exp(1.0), 2e-6) << one.name;
  }
}

// Beyond an equibiaxial stretch of sqrt(20) incompressible fabric is thinner than the floor of 0.05: the path says
// where it ends. No other path ends before 6.
TEST(Paths, EndWhereTheLawRefuses) {
  for (const Path& one : paths()) {
    const Losses lost = losses(published("neo-hookean, pantyhose"), one, 6.0);
    EXPECT_EQ(lost.state.has_value(), one.wale && one.course) << one.name;
    if (lost.state) {
      EXPECT_NEAR(*lost.state, std::sqrt(20.0), 2e-6);
    }
  }
}

// Equation of the strip: W(l) = C10 (l^2 + l^-2 - 2) + psi(ln l), so the acoustic tensor along the course
// vanishes and the force turns where
// 2 C10 (1 + 3 l^-4) + (E(e) - s(e))/l^2 = 0 with the tangent modulus E and the Kirchhoff stress s of the course fibre.
TEST(Paths, StripLossIsTheRootOfItsEquation) {
  const Losses lost = losses(literal_form(published("rebar, pantyhose")).front(), path("strip course"), 6.0);
  const double d[] = {0.0032, -0.075, 0.4653, -1.340, 1.9400, -0.986};
  const auto curvature = [&](double l) {
    double E = 0.0, s = 0.0;
    const double e = std::log(l);
    for (int i = 5; i >= 0; --i) E += d[i] * std::pow(e, i), s += d[i] * std::pow(e, i + 1) / (i + 1);
    return 2.0 * 8.4667e-3 * (1.0 + 3.0 / std::pow(l, 4)) + (E - s) / (l * l);
  };
  ASSERT_TRUE(lost.ellipticity && lost.force);
  EXPECT_GT(curvature(*lost.ellipticity - 2e-6), 0.0);
  EXPECT_LT(curvature(*lost.ellipticity + 1e-6), 0.0);
  EXPECT_NEAR(*lost.force, *lost.ellipticity, 2.0 * 5.0 / 400);
}

// Uniaxial neo-Hookean tension has the closed form l2 = l^(-1/2).
TEST(Paths, FreeAxisIsFreeOfStress) {
  const auto s = state_on(published("neo-hookean, pantyhose"), path("uniaxial wale"), 2.0, {4.0, 0.7, 0.01});
  ASSERT_TRUE(s);
  EXPECT_NEAR(s->C[1], 0.5, 1e-10);
  EXPECT_NEAR(s->C[2], 0.0, 1e-10);
}

// Saint Venant-Kirchhoff in uniaxial compression loses its stability at a stretch of 1/sqrt(3), where its nominal force
// Y l (l^2 - 1)/2 turns.
TEST(Paths, SaintVenantKirchhoffCollapses) {
  const Fabric law{"svk", material::find("isotropic-elastic"), {1.0, 0.0}};
  const Losses lost = losses(law, path("uniaxial wale"), 0.3);
  ASSERT_TRUE(lost.convexity && lost.force);
  EXPECT_NEAR(*lost.convexity, 1.0 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(*lost.force, 1.0 / std::sqrt(3.0), 3e-3);
}

}  // namespace
}  // namespace toile::criteria::test
