#include "evaluation.hpp"

namespace toile::material::test {
namespace {

constexpr double young = 0.08;

Point at(double poisson, const State& C) {
  return evaluate(law("isotropic-elastic"), {young, poisson}, C);
}

// Stress and Green strain follow Hooke's law of plane stress, also at large strain.
TEST(IsotropicElastic, hooke) {
  for (double nu : {-0.5, 0.0, 0.3, 0.5})
    for (const State& C : random_states(5, 0.7, 1.6, 8)) {
      const Point p = at(nu, C);
      EXPECT_NEAR((p.S[0] - nu * p.S[1]) / young, 0.5 * (C[0] - 1.0), 1e-14);
      EXPECT_NEAR((p.S[1] - nu * p.S[0]) / young, 0.5 * (C[1] - 1.0), 1e-14);
      EXPECT_NEAR(p.S[2], young / (1.0 + nu) * 0.5 * C[2], 1e-15);
      EXPECT_NEAR(p.tangent(2, 2), 0.5 * young / (1.0 + nu), 1e-15);
    }
}

// The thickness strain is -nu/(1 - nu) times the sum of the others; at nu = 1/2 small strains keep the volume.
TEST(IsotropicElastic, thickness) {
  EXPECT_EQ(at(0.0, {1.5, 1.2, 0.1}).thickness_stretch, 1.0);
  EXPECT_NEAR(at(0.3, {1.2, 1.1, 0.1}).thickness_stretch, std::sqrt(1.0 - 0.3 / 0.7 * 0.3), 1e-15);
  EXPECT_GT(at(-0.3, {1.2, 1.1, 0.1}).thickness_stretch, 1.0);
  const double e = 1e-5;
  EXPECT_NEAR(at(0.5, {1.0 + e, 1.0 + e, 0.0}).thickness_stretch * (1.0 + e), 1.0, 2.0 * e * e);
}

// Where the linear thickness strain would turn the fabric inside out, the thickness stays at the floor of the
// stretches.
TEST(IsotropicElastic, thickness_is_bounded) {
  const Point p = at(0.5, {6.0, 6.0, 0.0});
  EXPECT_NEAR(p.thickness_stretch, 0.05, 1e-16);
  EXPECT_EQ(p.status, point_ok);
}

}  // namespace
}  // namespace toile::material::test
