#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>
#include <cmath>

#include "support.hpp"

namespace toile::element::testing {
namespace {

constexpr double wale_angle = 0.35;
constexpr double thickness = 0.8;
const double pi = std::acos(-1.0);

/// Smooth deformation of the unit square into space: stretched by about 1.4 and 1.25 with waves in and out of plane.
Eigen::Vector3d exact(const Eigen::Vector2d& X) {
  const double s = std::sin(pi * X[0]), t = std::sin(pi * X[1]);
  return {1.4 * X[0] + 0.1 * X[1] + 0.04 * s * t, 1.25 * X[1] + 0.04 * std::sin(2.0 * X[0] + X[1]),
          0.15 * s * t + 0.1 * X[0] * X[1]};
}

Eigen::Matrix<double, 3, 2> exact_F(const Eigen::Vector2d& X) {
  const double s = std::sin(pi * X[0]), t = std::sin(pi * X[1]);
  const double ds = pi * std::cos(pi * X[0]), dt = pi * std::cos(pi * X[1]), wave = 0.04 * std::cos(2.0 * X[0] + X[1]);
  Eigen::Matrix<double, 3, 2> F;
  F << 1.4 + 0.04 * ds * t, 0.1 + 0.04 * s * dt,  //
      2.0 * wave, 1.25 + wave,                    //
      0.15 * ds * t + 0.1 * X[1], 0.15 * s * dt + 0.1 * X[0];
  return F;
}

/// First Piola-Kirchhoff force per length of the exact deformation, h0 F R S R^T (3 x 2).
Eigen::Matrix<double, 3, 2> exact_stress(const Law& law, const Eigen::Vector2d& X) {
  Eigen::Matrix2d R;
  R << std::cos(wale_angle), -std::sin(wale_angle), std::sin(wale_angle), std::cos(wale_angle);
  const Eigen::Matrix<double, 3, 2> F = exact_F(X) * R;
  const double C[3] = {F.col(0).squaredNorm(), F.col(1).squaredNorm(), F.col(0).dot(F.col(1))};
  double W, S[3], stretch;
  std::uint8_t status;
  law.response->evaluate(1, C, law.params.data(), 0, &W, S, nullptr, &stretch, &status);
  Eigen::Matrix2d stress;
  stress << S[0], S[2], S[2], S[1];
  return thickness * F * stress * R.transpose();
}

struct Sample {
  double weight;
  std::array<double, 4> N;                  ///< a triangle uses the first three
  std::array<Eigen::Vector2d, 4> gradient;  ///< in the pattern's axes
  Eigen::Vector2d X;
};

/// 6 x 6 Gauss points of one element, on a triangle with the square collapsed onto it. Written independently of the
/// package: it is the oracle.
std::vector<Sample> samples(const std::vector<Eigen::Vector2d>& X) {
  const double half[3] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
  const double weights[3] = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  std::vector<Sample> result;
  for (int k = 0; k < 36; ++k) {
    const auto place = [&](int i) { return 0.5 + 0.5 * (i < 3 ? -half[i] : half[i - 3]); };
    double s = place(k % 6), t = place(k / 6), w = 0.25 * weights[k % 6 % 3] * weights[k / 6 % 3];
    Sample sample;
    std::array<Eigen::Vector2d, 4> slope;
    if (X.size() == 4) {
      sample.N = {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t};
      slope = {Eigen::Vector2d(t - 1, s - 1), {1 - t, -s}, {t, s}, {-t, 1 - s}};
    } else {
      w *= 1 - s;
      t *= 1 - s;
      sample.N = {1 - s - t, s, t, 0};
      slope = {Eigen::Vector2d(-1, -1), {1, 0}, {0, 1}, {0, 0}};
    }
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    sample.X.setZero();
    for (std::size_t i = 0; i < X.size(); ++i) {
      J += X[i] * slope[i].transpose();
      sample.X += sample.N[i] * X[i];
    }
    for (std::size_t i = 0; i < X.size(); ++i) sample.gradient[i] = J.inverse().transpose() * slope[i];
    sample.weight = w * J.determinant();
    result.push_back(sample);
  }
  return result;
}

class Problem {
 public:
  Problem(const Element& element, const Law& law, int cells)
      : element_(element), law_(law), mesh_(square_mesh(cells, 1.0, 0.2, element.nodes())) {
    load_ = Eigen::VectorXd::Zero(unknowns());
    for (int e = 0; e < mesh_.elements(); ++e) {
      for (const Sample& sample : samples(corners(e))) {
        const auto P = exact_stress(law_, sample.X);
        for (int i = 0; i < element_.nodes(); ++i) {
          load_.segment<3>(3 * node(e, i)) += sample.weight * P * sample.gradient[i];
        }
      }
    }
  }

  /// Newton from a start that is the exact deformation at the boundary and disturbed inside.
  Eigen::VectorXd solve() const {
    Eigen::VectorXd x(unknowns());
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
      x.segment<3>(3 * i) = exact(mesh_.nodes[i]);
      if (!mesh_.boundary[i]) x[3 * i + 2] += 0.01 * std::sin(5.0 * mesh_.nodes[i][0]);
    }
    for (int iteration = 0; iteration < 20; ++iteration) {
      const Eigen::VectorXd change = newton_step(x);
      x += change;
      if (change.cwiseAbs().maxCoeff() < 1e-12) return x;
    }
    ADD_FAILURE() << "Newton did not converge";
    return x;
  }

  /// L2 norm of the difference to the exact deformation.
  double error(const Eigen::VectorXd& x) const {
    double squared = 0.0;
    for (int e = 0; e < mesh_.elements(); ++e) {
      for (const Sample& sample : samples(corners(e))) {
        Eigen::Vector3d difference = -exact(sample.X);
        for (int i = 0; i < element_.nodes(); ++i) difference += sample.N[i] * x.segment<3>(3 * node(e, i));
        squared += sample.weight * difference.squaredNorm();
      }
    }
    return std::sqrt(squared);
  }

 private:
  int unknowns() const { return 3 * static_cast<int>(mesh_.nodes.size()); }
  int node(int e, int i) const { return mesh_.connectivity[e * element_.nodes() + i]; }

  std::vector<Eigen::Vector2d> corners(int e) const {
    std::vector<Eigen::Vector2d> X;
    for (int i = 0; i < element_.nodes(); ++i) X.push_back(mesh_.nodes[node(e, i)]);
    return X;
  }

  Eigen::VectorXd newton_step(const Eigen::VectorXd& x) const {
    Arrays arrays = gather(mesh_, element_, law_, wale_angle, x);
    arrays.thickness = thickness;
    const Values values = evaluate(arrays);
    Eigen::VectorXd residual = load_ - scatter(mesh_, values.residual);
    const int ndof = element_.ndof();
    std::vector<Eigen::Triplet<double>> entries;
    const auto is_fixed = [&](int e, int dof) { return mesh_.boundary[node(e, dof / 3)]; };
    for (int e = 0; e < mesh_.elements(); ++e) {
      for (int r = 0; r < ndof; ++r) {
        for (int c = 0; c < ndof; ++c) {
          if (is_fixed(e, r) || is_fixed(e, c)) continue;
          entries.emplace_back(3 * node(e, r / 3) + r % 3, 3 * node(e, c / 3) + c % 3, values.tangent(e * ndof + r, c));
        }
      }
    }
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
      if (!mesh_.boundary[i]) continue;
      residual.segment<3>(3 * i).setZero();
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) entries.emplace_back(k, k, 1.0);
    }
    Eigen::SparseMatrix<double> K(unknowns(), unknowns());
    K.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(residual);
  }

  const Element& element_;
  const Law& law_;
  PlaneMesh mesh_;
  Eigen::VectorXd load_;
};

class MembraneConvergence : public ::testing::TestWithParam<std::tuple<const Element*, Law>> {};

// On distorted meshes the displacement of a smooth manufactured solution (in and out of plane, wale 20 degrees from the
// pattern's axis) converges in L2 with at least 95 % of second order, over three meshes.
TEST_P(MembraneConvergence, DisplacementIsSecondOrder) {
  const auto& [element, law] = GetParam();
  std::array<double, 3> error;
  for (int level = 0; level < 3; ++level) {
    const Problem problem(*element, law, 8 << level);
    error[level] = problem.error(problem.solve());
  }
  EXPECT_LT(error[0], 1e-2);
  EXPECT_GT(error[2], 1e-6);
  for (int level = 0; level < 2; ++level) {
    const double rate = std::log2(error[level] / error[level + 1]);
    RecordProperty("rate_" + std::to_string(level), std::to_string(rate));
    EXPECT_GE(rate, 0.95 * 2.0) << "errors " << error[level] << " and " << error[level + 1];
  }
}

INSTANTIATE_TEST_SUITE_P(All, MembraneConvergence,
                         ::testing::Combine(::testing::ValuesIn(membranes()), ::testing::ValuesIn(laws())), case_name);

}  // namespace
}  // namespace toile::element::testing
