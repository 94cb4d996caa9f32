#include "toile/contact/law.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "toile/body/analytic.hpp"
#include "toile/contact/laws.hpp"
#include "toile/contact/recovery.hpp"

namespace toile::contact {
namespace {

constexpr double stiffness = 3.0;  // N/mm
constexpr double offset = 0.4;     // mm

/// Node whose contact surface has the gap `gap` (mm) to an ellipsoid of semi-axes 40, 40, 70 mm.
class OnEllipsoid : public testing::Test {
 protected:
  Vec3 node(double gap) {
    std::normal_distribution<double> normal;
    const Vec3 direction = Vec3(normal(random_), normal(random_), normal(random_)).normalized();
    const body::SurfacePoint foot = surface_->closest(Vec3(45.0, 45.0, 75.0).cwiseProduct(direction));
    return foot.closest + (gap + offset) * foot.normal;
  }
  NodeContact at(const Vec3& x, double multiplier) const { return with_stiffness(x, multiplier, stiffness); }
  NodeContact with_stiffness(const Vec3& x, double multiplier, double k) const {
    return frictionless()->evaluate({surface_->closest(x), offset, multiplier, k});
  }

  body::SurfacePtr surface_ = body::ellipsoid(40.0, 70.0);
  std::mt19937 random_{11};
};

// The residual is the gradient of the energy and does not vanish, for touching, penetrating and hovering nodes.
TEST_F(OnEllipsoid, ResidualIsGradientOfEnergy) {
  constexpr double h = 1e-5;
  for (const double gap : {-0.3, -0.01, 0.0, 0.2}) {
    const Vec3 x = node(gap);
    const NodeContact c = at(x, 1.5);
    ASSERT_TRUE(c.active);
    EXPECT_GT(c.residual.norm(), 0.1);
    for (int i = 0; i < 3; ++i) {
      const Vec3 d = h * Vec3::Unit(i);
      EXPECT_NEAR((at(x + d, 1.5).energy - at(x - d, 1.5).energy) / (2.0 * h), c.residual[i], 1e-8) << "gap " << gap;
    }
  }
}

// stiffness n n^T + tangent is the gradient of the residual; the curvature of the body is in it.
TEST_F(OnEllipsoid, TangentIsGradientOfResidual) {
  constexpr double h = 1e-5;
  for (const double gap : {-0.3, 0.0, 0.2}) {
    const Vec3 x = node(gap);
    const NodeContact c = at(x, 1.5);
    const Mat3 hessian = stiffness * c.normal * c.normal.transpose() + c.tangent;
    EXPECT_GT(c.tangent.norm(), 0.01);
    EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-14);
    for (int i = 0; i < 3; ++i) {
      const Vec3 d = h * Vec3::Unit(i);
      const Vec3 column = (at(x + d, 1.5).residual - at(x - d, 1.5).residual) / (2.0 * h);
      EXPECT_LT((column - hessian.col(i)).norm(), 1e-8) << "gap " << gap;
    }
  }
}

// A node that hovers further than its multiplier reaches feels nothing, and its multiplier is driven to zero.
TEST_F(OnEllipsoid, FreeNodeFeelsNothing) {
  const NodeContact c = at(node(0.6), 1.5);
  EXPECT_FALSE(c.active);
  EXPECT_EQ(c.residual.norm(), 0.0);
  EXPECT_EQ(c.tangent.norm(), 0.0);
  EXPECT_DOUBLE_EQ(c.energy, -1.5 * 1.5 / (2.0 * stiffness));
  EXPECT_DOUBLE_EQ(c.complementarity, 1.5 / stiffness);
  EXPECT_EQ(at(node(0.6), 0.0).complementarity, 0.0);
}

// Energy and residual are continuous where contact begins, so that the line search sees no step.
TEST_F(OnEllipsoid, ContinuousWhereContactBegins) {
  const Vec3 x = node(0.5);  // 1.5 N / 3 N/mm
  const Vec3 shift = 1e-9 * at(x, 1.5).normal;
  const NodeContact inside = at(x - shift, 1.5), outside = at(x + shift, 1.5);
  EXPECT_TRUE(inside.active);
  EXPECT_FALSE(outside.active);
  EXPECT_NEAR(inside.energy, outside.energy, 1e-12);
  EXPECT_NEAR((inside.residual - outside.residual).norm(), 0.0, 1e-8);
}

// In contact the complementarity is the gap of the contact surface, whatever the stiffness: the multiplier is exact at
// gap zero.
TEST_F(OnEllipsoid, ComplementarityIsGapInContact) {
  const Vec3 x = node(-0.05);
  for (const double k : {0.3, 3.0, 30.0}) {
    const NodeContact c = with_stiffness(x, 2.0, k);
    EXPECT_NEAR(c.gap, -0.05, 1e-10);
    EXPECT_NEAR(c.complementarity, c.gap, 1e-13);
    EXPECT_NEAR(c.trial_force, 2.0 + 0.05 * k, 1e-9);
  }
  const NodeContact settled = at(node(0.0), 2.0);
  EXPECT_NEAR(settled.complementarity, 0.0, 1e-10);
  EXPECT_NEAR((settled.residual + 2.0 * settled.normal).norm(), 0.0, 1e-9);
}

// The start multiplier balances the normal part of a force that presses a touching node onto the body, and only that.
TEST_F(OnEllipsoid, BalancingMultiplier) {
  const NodeContact touching = at(node(0.0), 0.0);
  const Vec3 tangential = touching.normal.unitOrthogonal();
  const Vec3 inwards = 0.7 * touching.normal + 5.0 * tangential;  // gradient of an energy that falls towards the body
  EXPECT_NEAR(balancing_multiplier(touching, inwards, 0.1), 0.7, 1e-14);
  EXPECT_EQ(balancing_multiplier(touching, -inwards, 0.1), 0.0);
  EXPECT_EQ(balancing_multiplier(at(node(0.2), 0.0), inwards, 0.1), 0.0);
  const NodeContact near = at(node(0.05), 0.0);
  EXPECT_NEAR(balancing_multiplier(near, 0.7 * near.normal, 0.1), 0.7, 1e-14);
}

// Pressure is force per area, and zero for a node without an element.
TEST(Pressure, ForcePerArea) {
  EXPECT_DOUBLE_EQ(pressure(0.02, 8.0), 0.0025);
  EXPECT_EQ(pressure(0.02, 0.0), 0.0);
}

}  // namespace
}  // namespace toile::contact
