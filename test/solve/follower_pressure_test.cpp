#include "terms/follower_pressure.hpp"
#include "terms/pressure_edges.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace toile::test {
namespace {

using solve::pressure_on_element;

/// Nodes of a warped element.
std::array<double, 12> warped() {
  std::array<double, 12> x{};
  const double corner[4][3] = {{0, 0, 0.2}, {2, 0.1, -0.3}, {2.2, 1.5, 0.4}, {-0.1, 1.3, 0.1}};
  for (size_t i = 0; i < 4; ++i)
    for (size_t d = 0; d < 3; ++d) x[3 * i + d] = corner[i][d] + 3.0;
  return x;
}

class FollowerPressure : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Nodes, FollowerPressure, testing::Values(3, 4));

// The stiffness is the second derivative of -p volume.
TEST_P(FollowerPressure, StiffnessIsTheSecondDerivativeOfTheVolume) {
  const int n = GetParam();
  std::array<double, 12> x = warped();
  std::array<double, 144> stiffness{};
  constexpr double p = 0.7, h = 1e-4;
  pressure_on_element(n, x.data(), p, stiffness.data());
  double size = 0.0;
  for (int r = 0; r < 3 * n; ++r)
    for (int c = 0; c < 3 * n; ++c) {
      double sum = 0.0;
      for (const double i : {-1.0, 1.0})
        for (const double j : {-1.0, 1.0}) {
          std::array<double, 12> y = x;
          y[static_cast<size_t>(r)] += i * h;
          y[static_cast<size_t>(c)] += j * h;
          sum -= i * j * p * pressure_on_element(n, y.data(), p, nullptr).volume;
        }
      const double K = stiffness[static_cast<size_t>(r * 3 * n + c)];
      EXPECT_NEAR(sum / (4.0 * h * h), K, 1e-6) << r << " " << c;
      size = std::max(size, std::abs(K));
    }
  EXPECT_GT(size, 0.1);
}

// The forces on a plane element are pressure times area along its normal.
TEST_P(FollowerPressure, ForceIsPressureTimesAreaAlongTheNormal) {
  const int n = GetParam();
  std::array<double, 12> x{};
  const double corner[4][2] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  for (size_t i = 0; i < 4; ++i)
    for (size_t d = 0; d < 2; ++d) x[3 * i + d] = corner[i][d];
  const auto found = pressure_on_element(n, x.data(), 3.0, nullptr);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < n; ++i) sum += Eigen::Vector3d(found.force + 3 * i);
  EXPECT_LT((sum - Eigen::Vector3d(0, 0, n == 4 ? 6.0 : 3.0)).norm(), 1e-12);
}

// On a closed surface the force is p times the gradient of the volume.
TEST(FollowerPressureOnABox, ForceIsTheGradientOfTheVolume) {
  std::array<std::array<double, 3>, 8> node{};
  for (size_t k = 0; k < 8; ++k) node[k] = {double(k & 1), double((k >> 1) & 1), double(k >> 2) + 0.1 * double(k % 3)};
  const int face[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const auto evaluate = [&](double* force) {
    double volume = 0.0;
    for (const auto& f : face) {
      double x[12];
      for (int i = 0; i < 4; ++i) std::copy_n(node[static_cast<size_t>(f[i])].data(), 3, x + 3 * i);
      const auto found = pressure_on_element(4, x, 1.0, nullptr);
      volume += found.volume;
      for (int i = 0; i < 12 && force != nullptr; ++i) force[3 * f[i / 3] + i % 3] += found.force[i];
    }
    return volume;
  };
  double force[24] = {};
  EXPECT_GT(evaluate(force), 0.5);
  constexpr double h = 1e-5;
  for (size_t k = 0; k < 24; ++k) {
    double& x = node[k / 3][k % 3];
    x += h;
    const double up = evaluate(nullptr);
    x -= 2.0 * h;
    const double down = evaluate(nullptr);
    x += h;
    EXPECT_NEAR((up - down) / (2.0 * h), force[k], 1e-8) << k;
  }
}

/// Three elements side by side. Their nodes 0 to 3 lie in the plane y = 7, in which 1 and 2 slide; 4 to 7 are held.
class SlidingEdge : public testing::Test {
 protected:
  using Vec3 = Eigen::Vector3d;
  static constexpr double h = 1e-4;

  SlidingEdge() {
    for (int i = 0; i < 4; ++i) {
      x_[static_cast<size_t>(i)] = Vec3(5.0 + 2.0 * i, 7.0, 3.0 + 0.4 * i * i);
      x_[static_cast<size_t>(i + 4)] = Vec3(4.8 + 2.1 * i, 8.5 + 0.2 * i, 2.5 - 0.3 * i);
    }
    start_ = x_;
  }

  static std::array<int, 4> element(int e) { return {e, e + 1, e + 5, e + 4}; }

  /// Force of a pressure 1 on node `n`, N; `potential`, or null, gets the potential about the start.
  Vec3 force(int n, double* potential) const {
    Vec3 sum = Vec3::Zero();
    for (int e = 0; e < 3; ++e) {
      double x[12];
      const std::array<int, 4> nodes = element(e);
      for (size_t i = 0; i < 4; ++i) std::copy_n(at(nodes[i]).data(), 3, x + 3 * i);
      const auto found = pressure_on_element(4, x, 1.0, nullptr);
      for (size_t i = 0; i < 4; ++i)
        if (nodes[i] == n) sum += Vec3(found.force + 3 * i);
      const size_t a = static_cast<size_t>(e), b = a + 1;
      if (potential != nullptr) *potential += solve::edge_work(start_[a], start_[b], x_[a], x_[b]) - found.volume;
    }
    return sum;
  }
  const Vec3& at(int n) const { return x_[static_cast<size_t>(n)]; }

  std::array<Vec3, 8> x_, start_;
};

// Where an edge slides in a plane, off the origin too, the force is the gradient of the potential however far it slid.
TEST_F(SlidingEdge, HasAPotential) {
  x_[1] += Vec3(1.5, 0.0, -0.8);
  x_[2] += Vec3(-0.7, 0.0, 1.1);
  for (const int n : {1, 2})
    for (const int d : {0, 2}) {
      const double expected = force(n, nullptr)[d];
      double up = 0.0, down = 0.0;
      x_[static_cast<size_t>(n)][d] += h;
      force(n, &up);
      x_[static_cast<size_t>(n)][d] -= 2.0 * h;
      force(n, &down);
      x_[static_cast<size_t>(n)][d] += h;
      EXPECT_NEAR((down - up) / (2.0 * h), expected, 1e-8) << n << " " << d;
    }
}

// The stiffness of the volume and that of the edge are together the derivative of the force.
TEST_F(SlidingEdge, StiffnessIsTheDerivativeOfTheForce) {
  double x[12], K[144] = {};
  for (size_t i = 0; i < 4; ++i) std::copy_n(at(element(1)[i]).data(), 3, x + 3 * i);
  pressure_on_element(4, x, 1.0, K);
  const Eigen::Matrix3d edge = solve::edge_stiffness(at(1), at(2));
  for (const int row : {0, 2})
    for (const int column : {0, 2}) {
      x_[2][column] += h;
      const double up = force(1, nullptr)[row];
      x_[2][column] -= 2.0 * h;
      const double down = force(1, nullptr)[row];
      x_[2][column] += h;
      EXPECT_NEAR((down - up) / (2.0 * h), K[12 * row + 3 + column] + edge(row, column), 1e-8) << row << column;
    }
  EXPECT_GT(std::abs(edge(0, 2)), 1.0);
}

}  // namespace
}  // namespace toile::test
