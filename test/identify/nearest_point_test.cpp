#include "nearest_point.hpp"

#include <gtest/gtest.h>

#include <random>

namespace toile::identify::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The nearest point y of a polyhedron to a point p lies in it, and no point z of it lies on p's side of y:
// (p - y).(z - y) <= 0. Also where limits outnumber the variables, are twice the same, or meet in y.
TEST(NearestPoint, IsTheNearest) {
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  const auto random = [&](Index rows, Index columns) {
    return MatrixXd(MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); }));
  };
  for (const Index n : {1, 3, 12})
    for (const Index m : {1, 5, 40}) {
      Inequalities limits = {random(m, n), random(m, 1).cwiseAbs()};  // holds the origin
      limits.G.row(m - 1) = limits.G.row(0);
      limits.h[m - 1] = limits.h[0];
      const VectorXd p = 5.0 * random(n, 1);
      const auto y = nearest_point(p, limits);
      ASSERT_TRUE(y) << n << " " << m;
      EXPECT_LE((limits.G * *y - limits.h).maxCoeff(), 1e-12 * p.norm()) << n << " " << m;
      for (int i = 0; i < 200; ++i) {
        VectorXd z = random(n, 1);
        const VectorXd taken = limits.G * z;
        double part = 1.0;  // of the way from the origin that stays within the limits
        for (Index k = 0; k < m; ++k)
          if (taken[k] > limits.h[k]) part = std::min(part, limits.h[k] / taken[k]);
        z *= part;
        EXPECT_LE((p - *y).dot(z - *y), 1e-11 * p.squaredNorm()) << n << " " << m;
      }
    }
}

// A point within the limits is its own nearest, and a limit that is a millionth of the way off is met as exactly.
TEST(NearestPoint, NearAndFar) {
  const Inequalities box = {MatrixXd::Identity(2, 2), VectorXd::Constant(2, 1e-6)};
  EXPECT_EQ(*nearest_point(VectorXd::Constant(2, -1.0), box), VectorXd::Constant(2, -1.0));
  const VectorXd y = *nearest_point(VectorXd::Constant(2, 1.0), box);
  EXPECT_NEAR(y[0], 1e-6, 1e-14);
  EXPECT_NEAR(y[1], 1e-6, 1e-14);
}

// Limits that contradict each other have no point.
TEST(NearestPoint, Contradiction) {
  Inequalities limits = {MatrixXd(2, 1), VectorXd::Constant(2, -1.0)};
  limits.G << 1.0, -1.0;
  EXPECT_FALSE(nearest_point(VectorXd::Zero(1), limits));
}

}  // namespace
}  // namespace toile::identify::test
