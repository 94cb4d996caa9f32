#include "evaluation.hpp"

namespace toile::material::test {
namespace {

constexpr double young = 0.08;

Point at(double poisson, const State& C) {
  return evaluate(law("hencky"), {young, poisson}, C);
}

/// C of the principal stretches a and b, the first at `angle` from the wale.
State stretched(double a, double b, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {a * a * c * c + b * b * s * s, a * a * s * s + b * b * c * c, (a * a - b * b) * c * s};
}

// A strip that is free to contract, lateral strain -nu times the axial one, has the Kirchhoff stress Y ln(stretch),
// from 0.3 to 5.
TEST(Hencky, uniaxial) {
  for (double nu : {-0.5, 0.0, 0.3, 0.5})
    for (double stretch : {0.3, 0.6, 0.95, 1.0, 1.001, 1.4, 2.0, 5.0}) {
      const Point p = at(nu, stretched(stretch, std::pow(stretch, -nu), 0.0));
      EXPECT_EQ(p.status, point_ok);
      EXPECT_NEAR(p.S[0] * stretch * stretch, young * std::log(stretch), 1e-15);
      EXPECT_NEAR(p.S[1] * std::pow(stretch, -2.0 * nu), 0.0, 1e-15);
      EXPECT_NEAR(p.W, 0.5 * young * std::log(stretch) * std::log(stretch), 1e-15);
      EXPECT_NEAR(p.thickness_stretch, std::pow(stretch, -nu), 1e-14 * std::pow(stretch, -nu));
    }
}

// Equal stretches, 0.3 to 5: the Kirchhoff stress is Y/(1 - nu) ln(stretch), and the tangent is that of the principal
// axes, in which the shear modulus is half the difference of D11 and D12.
TEST(Hencky, equibiaxial) {
  for (double nu : {-0.5, 0.0, 0.3, 0.5})
    for (double stretch : {0.3, 0.7, 1.0, 1.3, 4.0}) {
      const Point p = at(nu, {stretch * stretch, stretch * stretch, 0.0});
      const double fourth = std::pow(stretch, 4), plane = young / (1.0 - nu * nu), e = std::log(stretch);
      const double D11 = plane * (1.0 - 2.0 * (1.0 + nu) * e) / fourth, D12 = plane * nu / fourth;
      for (int a = 0; a < 2; ++a) {
        EXPECT_NEAR(p.S[a] * stretch * stretch, young / (1.0 - nu) * e, 1e-15);
        EXPECT_NEAR(p.tangent(a, a), D11, 1e-14 * std::abs(D11));
        EXPECT_EQ(p.tangent(a, 2), 0.0);
      }
      EXPECT_EQ(p.S[2], 0.0);
      EXPECT_NEAR(p.tangent(0, 1), D12, 1e-14 * std::abs(D11));
      EXPECT_NEAR(p.tangent(2, 2), 0.5 * (D11 - D12), 1e-14 * std::abs(D11));
    }
}

// Stretches that differ by 1e-9 of themselves, along any axes, leave stress and tangent within the same of those of
// equal stretches.
TEST(Hencky, nearly_equal_stretches) {
  for (double stretch : {0.5, 1.0, 2.0})
    for (double angle : {0.0, 0.4, 1.1}) {
      const Point p = at(0.3, stretched(stretch, stretch, angle));
      const Point q = at(0.3, stretched(stretch * (1.0 + 1e-9), stretch, angle));
      for (int k = 0; k < 6; ++k) EXPECT_NEAR(q.D[k], p.D[k], 1e-7 * std::abs(p.D[0]));
      const double shear = (q.S[0] - q.S[1]) * std::cos(2.0 * angle) + 2.0 * q.S[2] * std::sin(2.0 * angle);
      const double difference = (p.D[0] - p.D[3]) * 1e-9 * stretch * stretch;
      EXPECT_NEAR(shear, difference, 1e-6 * std::abs(difference) + 1e-16);
    }
}

// Stress of principal stretches from 0.3 to 5, alike and far apart, turned by any angle, is that of their logarithms.
TEST(Hencky, principal_stresses) {
  const double nu = 0.3, plane = young / (1.0 - nu * nu);
  for (double a : {0.3, 0.8, 1.0, 1.1, 1.35, 2.0, 5.0})
    for (double b : {0.3, 0.9, 1.1, 3.9})
      for (double angle : {0.0, 0.6, 1.5}) {
        const Point p = at(nu, stretched(a, b, angle));
        const double e1 = std::log(a), e2 = std::log(b), c = std::cos(angle), s = std::sin(angle);
        const double S1 = plane * (e1 + nu * e2) / (a * a), S2 = plane * (e2 + nu * e1) / (b * b);
        const double scale = std::max({std::abs(S1), std::abs(S2), 1e-3});
        EXPECT_NEAR(p.W, 0.5 * plane * (e1 * e1 + e2 * e2 + 2.0 * nu * e1 * e2), 1e-15);
        EXPECT_NEAR(p.S[0], S1 * c * c + S2 * s * s, 1e-13 * scale);
        EXPECT_NEAR(p.S[1], S1 * s * s + S2 * c * c, 1e-13 * scale);
        EXPECT_NEAR(p.S[2], (S1 - S2) * c * s, 1e-13 * scale);
      }
}

// Where the series for like stretches ends, (difference over sum of the eigenvalues of C)^2 = 0.1, energy, stress and
// tangent go on without a step.
TEST(Hencky, series_meets_closed_form) {
  const double root = std::sqrt(0.1), stretch = std::sqrt((1.0 + root) / (1.0 - root));
  const Point below = at(0.3, stretched(stretch * (1.0 - 1e-14), 1.0, 0.3));
  const Point above = at(0.3, stretched(stretch * (1.0 + 1e-14), 1.0, 0.3));
  EXPECT_NEAR(above.W, below.W, 1e-14 * young);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(above.S[a], below.S[a], 1e-13 * young);
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(above.D[k], below.D[k], 1e-12 * young);
}

// For small strains it is the law that is linear in the Green strain, with its thickness.
TEST(Hencky, small_strain_is_isotropic_elastic) {
  for (double nu : {-0.5, 0.0, 0.3, 0.5}) {
    const Point rest = at(nu, {1.0, 1.0, 0.0}), elastic = evaluate(law("isotropic-elastic"), {young, nu}, {1, 1, 0});
    for (int k = 0; k < 6; ++k) EXPECT_NEAR(rest.D[k], elastic.D[k], 1e-14 * young);
    const double e = 1e-6;
    const State C = {1.0 + e, 1.0 - 0.4 * e, 0.7 * e};
    const Point p = at(nu, C), q = evaluate(law("isotropic-elastic"), {young, nu}, C);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(p.S[a], q.S[a], 10.0 * e * e * young);
    EXPECT_NEAR(p.thickness_stretch, q.thickness_stretch, 10.0 * e * e);
  }
}

}  // namespace
}  // namespace toile::material::test
