#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support.hpp"

namespace toile::element::testing {
namespace {

constexpr int count = 20;
constexpr double step = 1e-5;

class MembraneDerivatives : public ::testing::TestWithParam<std::tuple<const Element*, Law>> {
 protected:
  Arrays elements_ = random_elements(*std::get<0>(GetParam()), std::get<1>(GetParam()), count, 11);
  int ndof_ = elements_.element->ndof();

  /// Evaluation with unknown `dof` of every element moved by `change`.
  Values moved(int dof, double change) const {
    Arrays arrays = elements_;
    for (int e = 0; e < count; ++e) arrays.x[e * ndof_ + dof] += change;
    return evaluate(arrays);
  }
};

// The residual is the gradient of the energy (central differences, 1e-7 of its largest entry) and does not vanish.
TEST_P(MembraneDerivatives, ResidualIsGradientOfEnergy) {
  const Values values = evaluate(elements_);
  const double scale = values.residual.cwiseAbs().maxCoeff();
  EXPECT_GT(scale, 1e-4);
  for (int dof = 0; dof < ndof_; ++dof) {
    const Eigen::VectorXd slope = (moved(dof, step).energy - moved(dof, -step).energy) / (2.0 * step);
    for (int e = 0; e < count; ++e) EXPECT_NEAR(values.residual[e * ndof_ + dof], slope[e], 1e-7 * scale);
  }
}

// The tangent is the derivative of the residual (central differences, 1e-7 of its largest entry) and does not vanish.
TEST_P(MembraneDerivatives, TangentIsDerivativeOfResidual) {
  const Values values = evaluate(elements_);
  const double scale = values.tangent.cwiseAbs().maxCoeff();
  EXPECT_GT(scale, 1e-4);
  for (int dof = 0; dof < ndof_; ++dof) {
    const Eigen::VectorXd slope = (moved(dof, step).residual - moved(dof, -step).residual) / (2.0 * step);
    EXPECT_LT((values.tangent.col(dof) - slope).cwiseAbs().maxCoeff(), 1e-7 * scale) << "unknown " << dof;
  }
}

// The tangent is symmetric to round-off.
TEST_P(MembraneDerivatives, TangentIsSymmetric) {
  const Values values = evaluate(elements_);
  for (int e = 0; e < count; ++e) {
    const Eigen::MatrixXd K = values.tangent.middleRows(e * ndof_, ndof_);
    EXPECT_LT((K - K.transpose()).cwiseAbs().maxCoeff(), 1e-14 * K.cwiseAbs().maxCoeff());
  }
}

// A translation changes no force: the forces of an element add up to zero and the tangent has three null vectors.
TEST_P(MembraneDerivatives, TranslationIsNullVector) {
  const Values values = evaluate(elements_);
  const Eigen::MatrixXd shift = Eigen::Matrix3d::Identity().replicate(elements_.element->nodes(), 1);
  for (int e = 0; e < count; ++e) {
    const Eigen::MatrixXd K = values.tangent.middleRows(e * ndof_, ndof_);
    EXPECT_LT((K * shift).cwiseAbs().maxCoeff(), 1e-13 * K.cwiseAbs().maxCoeff());
    const Eigen::VectorXd r = values.residual.segment(e * ndof_, ndof_);
    EXPECT_LT((shift.transpose() * r).cwiseAbs().maxCoeff(), 1e-13 * r.cwiseAbs().maxCoeff());
  }
}

// Rotating and moving the deformed element keeps its energy, rotates its residual and rotates its tangent.
TEST_P(MembraneDerivatives, RigidMotionIsObjective) {
  const Values before = evaluate(elements_);
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()));
  Arrays turned = elements_;
  for (std::size_t k = 0; k < turned.x.size(); k += 3) {
    Eigen::Map<Eigen::Vector3d> x(turned.x.data() + k);
    x = (Q * x + Eigen::Vector3d(5.0, -3.0, 20.0)).eval();
  }
  const Values after = evaluate(turned);
  Eigen::MatrixXd rotation = Eigen::MatrixXd::Zero(ndof_, ndof_);
  for (int i = 0; i < ndof_; i += 3) rotation.block<3, 3>(i, i) = Q;
  const double force = before.residual.cwiseAbs().maxCoeff(), stiffness = before.tangent.cwiseAbs().maxCoeff();
  EXPECT_LT((after.energy - before.energy).cwiseAbs().maxCoeff(), 1e-12 * before.energy.cwiseAbs().maxCoeff());
  for (int e = 0; e < count; ++e) {
    const Eigen::VectorXd r = rotation * before.residual.segment(e * ndof_, ndof_);
    EXPECT_LT((after.residual.segment(e * ndof_, ndof_) - r).cwiseAbs().maxCoeff(), 1e-12 * force);
    const Eigen::MatrixXd K = rotation * before.tangent.middleRows(e * ndof_, ndof_) * rotation.transpose();
    EXPECT_LT((after.tangent.middleRows(e * ndof_, ndof_) - K).cwiseAbs().maxCoeff(), 1e-12 * stiffness);
  }
}

// The flat pattern placed anywhere by a rigid motion stores no energy and pulls at no node.
TEST_P(MembraneDerivatives, RigidPatternIsNaturalState) {
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.3, 1.0, -0.4).normalized()));
  const double stiffness = evaluate(elements_).tangent.cwiseAbs().maxCoeff();
  Arrays rigid = elements_;
  for (std::size_t k = 0; k < rigid.x.size() / 3; ++k) {
    Eigen::Map<Eigen::Vector3d> x(rigid.x.data() + 3 * k);
    x = Q * Eigen::Vector3d(rigid.pattern[2 * k], rigid.pattern[2 * k + 1], 4.0);
  }
  const Values values = evaluate(rigid);
  EXPECT_LT(values.energy.cwiseAbs().maxCoeff(), 1e-12 * stiffness);
  EXPECT_LT(values.residual.cwiseAbs().maxCoeff(), 1e-12 * stiffness);
}

INSTANTIATE_TEST_SUITE_P(All, MembraneDerivatives,
                         ::testing::Combine(::testing::ValuesIn(membranes()), ::testing::ValuesIn(laws())), case_name);

}  // namespace
}  // namespace toile::element::testing
