#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "shell_support.hpp"

namespace toile::element::testing {
namespace {

/// Strip along x of one row of cells, clamped at x = 0 and bent by a moment at its end; rotations about x are held, so
/// that it bends to a cylinder with the stiffness of a plate.
class Roll {
 public:
  static constexpr int cells = 24;
  static constexpr double length = 100.0, width = 5.0, thickness = 0.1;

  explicit Roll(const Element& element) {
    mesh_.nodes_per_element = element.nodes();
    for (int i = 0; i <= cells; ++i) {
      for (const double y : {0.0, width}) mesh_.nodes.push_back({length * i / cells, y});
    }
    for (int a = 0; a < 2 * cells; a += 2) {
      const std::vector<int> quad = {a, a + 2, a + 3, a + 1}, halves = {a, a + 2, a + 3, a, a + 3, a + 1};
      const auto& cell = element.nodes() == 4 ? quad : halves;
      mesh_.connectivity.insert(mesh_.connectivity.end(), cell.begin(), cell.end());
    }
    shells_ = flat_shells(mesh_, element, closed_neo_hookean(), 0.0);
    shells_.thickness = thickness;
  }

  /// The moment that bends the strip to a full circle.
  double full_moment() const {
    const double plate = 8.0 * shells_.law.params[0] * std::pow(thickness, 3) / 12.0;
    return 2.0 * std::acos(-1.0) / length * plate * width;
  }

  /// Newton to equilibrium with the end moment, from the frames of the state before. Returns the iterations.
  int bend_to(double moment) {
    freeze(shells_);
    for (int iteration = 1; iteration <= 30; ++iteration) {
      const Eigen::VectorXd change = newton_step(moment);
      for (std::size_t k = 0; k < mesh_.connectivity.size(); ++k) {
        Eigen::Map<Eigen::Matrix<double, 5, 1>>(&shells_.x[5 * k]) += change.segment<5>(5 * mesh_.connectivity[k]);
      }
      if (change.cwiseAbs().maxCoeff() > 1e-9) continue;
      carry_frames(shells_);
      return iteration;
    }
    ADD_FAILURE() << "Newton did not converge";
    return 0;
  }

  /// Position of the node at x = length, y = 0.
  Eigen::Vector3d tip() const {
    for (std::size_t k = 0; k < mesh_.connectivity.size(); ++k) {
      if (mesh_.connectivity[k] == 2 * cells) return Eigen::Map<const Eigen::Vector3d>(&shells_.x[5 * k]);
    }
    return Eigen::Vector3d::Zero();
  }

 private:
  Eigen::VectorXd newton_step(double moment) const {
    const Values values = evaluate(shells_);
    const int nodes = mesh_.nodes_per_element, ndof = 5 * nodes, unknowns = 5 * static_cast<int>(mesh_.nodes.size());
    Eigen::VectorXd residual = -scatter_shells(mesh_, values.residual);
    residual[unknowns - 2] += 0.5 * moment;
    residual[unknowns - 7] += 0.5 * moment;
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(unknowns, unknowns);
    for (int e = 0; e < shells_.size(); ++e) {
      for (int i = 0; i < nodes; ++i) {
        for (int j = 0; j < nodes; ++j) {
          const int row = 5 * mesh_.connectivity[e * nodes + i], column = 5 * mesh_.connectivity[e * nodes + j];
          K.block<5, 5>(row, column) += values.tangent.block<5, 5>(e * ndof + 5 * i, 5 * j);
        }
      }
    }
    for (int unknown = 0; unknown < unknowns; ++unknown) {
      const bool clamped = unknown < 10 && unknown != 6, about_x = unknown % 5 == 4;
      if (!clamped && !about_x) continue;
      K.row(unknown).setZero();
      K(unknown, unknown) = 1.0;
      residual[unknown] = 0.0;
    }
    return K.partialPivLu().solve(residual);
  }

  PlaneMesh mesh_;
  Arrays shells_;
};

class ShellRotation : public ::testing::TestWithParam<const Element*> {};

// A thin strip of 24 cells that an end moment rolls up passes through the half circle, its tip at 2 R above the clamp,
// and closes to the full circle, within 2 % of its length; frames are carried from step to step.
TEST_P(ShellRotation, EndMomentRollsStripToCircle) {
  Roll roll(*GetParam());
  const int steps = 40;
  const double pi = std::acos(-1.0);
  for (int step = 1; step <= steps; ++step) {
    roll.bend_to(roll.full_moment() * step / steps);
    if (HasFailure()) return;
    if (2 * step != steps) continue;
    const Eigen::Vector3d tip = roll.tip();
    EXPECT_NEAR(tip[0], 0.0, 0.02 * Roll::length);
    EXPECT_NEAR(std::abs(tip[2]), 2.0 * Roll::length / pi, 0.02 * Roll::length);
  }
  EXPECT_LT(std::hypot(roll.tip()[0], roll.tip()[2]), 0.02 * Roll::length);
}

// A director that turns by up to 60 degrees from one side of a single element to the other bends it by that angle over
// its length, not by the chord: the energy is that of a plate with this curvature, within 1e-4.
TEST_P(ShellRotation, CurvatureFollowsTheGreatCircle) {
  constexpr double length = 10.0, thickness = 0.01;
  PlaneMesh mesh;
  mesh.nodes_per_element = GetParam()->nodes();
  mesh.nodes = {{0.0, 0.0}, {length, 0.0}, {length, length}, {0.0, length}};
  mesh.connectivity = {0, 1, 2, 3};
  if (mesh.nodes_per_element == 3) mesh.connectivity = {0, 1, 3};
  Arrays shells = flat_shells(mesh, *GetParam(), closed_neo_hookean(), 0.4);
  shells.thickness = thickness;
  const double area = mesh.nodes_per_element == 3 ? 0.5 * length * length : length * length;
  const double plate = 8.0 * shells.law.params[0] * std::pow(thickness, 3) / 12.0;
  for (const double degrees : {1.0, 20.0, 60.0}) {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    for (std::size_t k = 0; k < mesh.connectivity.size(); ++k)
      shells.x[5 * k + 3] = mesh.nodes[mesh.connectivity[k]][0] > 0.0 ? 0.5 * angle : -0.5 * angle;
    const double curvature = angle / length, expected = 0.5 * plate * curvature * curvature * area;
    EXPECT_NEAR(evaluate(shells).energy[0] / expected, 1.0, 1e-4) << degrees;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShellRotation, ::testing::ValuesIn(shells()),
                         [](const auto& test) { return std::string(test.param->name()); });

}  // namespace
}  // namespace toile::element::testing
