#include <gtest/gtest.h>

#include "shell_support.hpp"

namespace toile::element::testing {
namespace {

constexpr int batch_size = 12;
constexpr double difference = 1e-5;

/// Positions and rotations have different units: their forces and stiffnesses are judged apart.
bool is_rotation(int dof) {
  return dof % 5 >= 3;
}

double largest(const Eigen::MatrixXd& values, bool row_rotation, bool column_rotation) {
  double result = 0.0;
  for (int r = 0; r < values.rows(); ++r) {
    for (int c = 0; c < values.cols(); ++c) {
      if (is_rotation(r) != row_rotation || is_rotation(c) != column_rotation) continue;
      result = std::max(result, std::abs(values(r, c)));
    }
  }
  return result;
}

class ShellDerivatives : public ::testing::TestWithParam<std::tuple<const Element*, Law>> {
 protected:
  const Element& element_ = *std::get<0>(GetParam());
  const Law& law_ = std::get<1>(GetParam());
  int ndof_ = element_.ndof();

  /// Flat and curved references, 1, 3, 5 and 7 layers.
  std::vector<Arrays> cases() const {
    std::vector<Arrays> all;
    for (const int layers : {1, 3, 5, 7}) {
      for (const bool curved : {false, true}) {
        all.push_back(random_shells(element_, law_, batch_size, 11 + layers, curved));
        all.back().layers = layers;
      }
    }
    return all;
  }

  /// Evaluation with unknown `dof` of every element moved by `change`.
  static Values moved(Arrays arrays, int dof, double change) {
    for (int e = 0; e < batch_size; ++e) arrays.x[e * arrays.element->ndof() + dof] += change;
    return evaluate(arrays);
  }
};

// The residual is the gradient of the energy (central differences, 1e-7 of its largest entry) and does not vanish, at
// rotations of 0.3 with respect to arbitrary frames.
TEST_P(ShellDerivatives, ResidualIsGradientOfEnergy) {
  for (const Arrays& elements : cases()) {
    const Values values = evaluate(elements);
    for (const bool rotation : {false, true}) {
      const double scale = largest(values.residual, rotation, false);
      EXPECT_GT(scale, 1e-4);
      for (int dof = 0; dof < ndof_; ++dof) {
        if (is_rotation(dof) != rotation) continue;
        const Eigen::VectorXd slope =
            (moved(elements, dof, difference).energy - moved(elements, dof, -difference).energy) / (2.0 * difference);
        for (int e = 0; e < batch_size; ++e) EXPECT_NEAR(values.residual[e * ndof_ + dof], slope[e], 1e-7 * scale);
      }
    }
  }
}

// The tangent is the derivative of the residual (central differences, 1e-7 of the largest entry of its kind) and does
// not vanish, so it is the exact Hessian at any rotation.
TEST_P(ShellDerivatives, TangentIsDerivativeOfResidual) {
  for (const Arrays& elements : cases()) {
    const Eigen::MatrixXd K = evaluate(elements).tangent;
    for (int dof = 0; dof < ndof_; ++dof) {
      const Eigen::VectorXd slope =
          (moved(elements, dof, difference).residual - moved(elements, dof, -difference).residual) / (2.0 * difference);
      const Eigen::VectorXd error = K.col(dof) - slope;
      for (const bool rotation : {false, true}) {
        double scale = 0.0;
        for (int column = 0; column < ndof_; ++column) {
          if (is_rotation(column) == is_rotation(dof)) {
            scale = std::max(scale, largest(K.col(column), rotation, false));
          }
        }
        EXPECT_GT(scale, 1e-4);
        EXPECT_LT(largest(error, rotation, false), 1e-7 * scale) << "unknown " << dof << ", rotation " << rotation;
      }
    }
  }
}

// The tangent is symmetric to the last bit.
TEST_P(ShellDerivatives, TangentIsSymmetric) {
  for (const Arrays& elements : cases()) {
    const Values values = evaluate(elements);
    for (int e = 0; e < batch_size; ++e) {
      const Eigen::MatrixXd K = values.tangent.middleRows(e * ndof_, ndof_);
      EXPECT_TRUE(K == K.transpose());
    }
  }
}

// Rotating and moving the element with its frames keeps its energy and its moments, and rotates its forces.
TEST_P(ShellDerivatives, RigidMotionIsObjective) {
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()));
  Eigen::MatrixXd rotation = Eigen::MatrixXd::Identity(ndof_, ndof_);
  for (int i = 0; i < ndof_; i += 5) rotation.block<3, 3>(i, i) = Q;
  for (const Arrays& elements : cases()) {
    Arrays turned = elements;
    for (std::size_t node = 0; node < turned.x.size() / 5; ++node) {
      Eigen::Map<Eigen::Vector3d> x(&turned.x[5 * node]);
      x = (Q * x + Eigen::Vector3d(5.0, -3.0, 20.0)).eval();
      Eigen::Map<Eigen::Matrix3d> frame(&turned.frames[9 * node]);
      frame = (Q * frame).eval();
    }
    const Values before = evaluate(elements), after = evaluate(turned);
    const double force = before.residual.cwiseAbs().maxCoeff(), stiffness = before.tangent.cwiseAbs().maxCoeff();
    EXPECT_LT((after.energy - before.energy).cwiseAbs().maxCoeff(), 1e-11 * before.energy.cwiseAbs().maxCoeff());
    for (int e = 0; e < batch_size; ++e) {
      const Eigen::VectorXd r = rotation * before.residual.segment(e * ndof_, ndof_);
      EXPECT_LT((after.residual.segment(e * ndof_, ndof_) - r).cwiseAbs().maxCoeff(), 1e-11 * force);
      const Eigen::MatrixXd K = rotation * before.tangent.middleRows(e * ndof_, ndof_) * rotation.transpose();
      EXPECT_LT((after.tangent.middleRows(e * ndof_, ndof_) - K).cwiseAbs().maxCoeff(), 1e-11 * stiffness);
    }
  }
}

// The energy knows the directors, not the frames: a frame that is carried to the present director, with its rotations
// set to zero, gives the same energy and forces.
TEST_P(ShellDerivatives, FramesAreOnlyCoordinates) {
  for (const Arrays& elements : cases()) {
    Arrays carried = elements;
    carry_frames(carried);
    const Values before = evaluate(elements), after = evaluate(carried);
    EXPECT_LT((after.energy - before.energy).cwiseAbs().maxCoeff(), 1e-11 * before.energy.cwiseAbs().maxCoeff());
    const double force = largest(before.residual, false, false);
    EXPECT_LT(largest(after.residual - before.residual, false, false), 1e-11 * force);
  }
}

// The reference, flat or curved, placed anywhere by a rigid motion stores no energy and pulls at no node.
TEST_P(ShellDerivatives, RigidReferenceIsNaturalState) {
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()));
  for (const Arrays& elements : cases()) {
    const double stiffness = evaluate(elements).tangent.cwiseAbs().maxCoeff();
    const Values values = evaluate(at_rest(elements, Q, {4.0, 5.0, 6.0}));
    EXPECT_LT(values.energy.cwiseAbs().maxCoeff(), 1e-12 * stiffness);
    EXPECT_LT(values.residual.cwiseAbs().maxCoeff(), 1e-12 * stiffness);
  }
}

// Rotations of any size, also half a turn and more, give unit directors and exact derivatives: the series for small
// rotations and the closed form for large ones agree with finite differences on both sides of their border.
TEST_P(ShellDerivatives, LargeRotationsHaveExactDerivatives) {
  for (const double size : {0.0, 1e-9, 1e-3, 0.999, 1.001, 3.0, 6.5}) {
    Arrays elements = random_shells(element_, law_, batch_size, 29, false);
    elements.layers = 1;  // the director acts through transverse shear alone, which admits any rotation
    for (std::size_t node = 0; node < elements.x.size() / 5; ++node) {
      elements.x[5 * node + 3] = 0.6 * size;
      elements.x[5 * node + 4] = -0.8 * size;
    }
    const Values values = evaluate(elements);
    const double force = values.residual.cwiseAbs().maxCoeff(), stiffness = values.tangent.cwiseAbs().maxCoeff();
    for (int dof = 3; dof < 5; ++dof) {
      const Values above = moved(elements, dof, difference), below = moved(elements, dof, -difference);
      const Eigen::VectorXd slope = (above.energy - below.energy) / (2.0 * difference);
      const Eigen::VectorXd column = (above.residual - below.residual) / (2.0 * difference);
      for (int e = 0; e < batch_size; ++e) EXPECT_NEAR(values.residual[e * ndof_ + dof], slope[e], 1e-7 * force);
      EXPECT_LT((values.tangent.col(dof) - column).cwiseAbs().maxCoeff(), 1e-7 * stiffness) << size;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShellDerivatives,
                         ::testing::Combine(::testing::ValuesIn(shells()), ::testing::ValuesIn(laws())), case_name);

}  // namespace
}  // namespace toile::element::testing
