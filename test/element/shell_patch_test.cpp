#include <gtest/gtest.h>

#include "shell_support.hpp"

namespace toile::element::testing {
namespace {

constexpr double angle_of_wale = 0.4;
constexpr double area = 900.0;

class ShellPatch : public ::testing::TestWithParam<const Element*> {
 protected:
  const Element& element_ = *GetParam();
  const Element& membrane_ = *find(element_.nodes() == 4 ? "membrane4" : "membrane3");
  PlaneMesh mesh_ = square_mesh(6, 30.0, 0.25, element_.nodes());
  Arrays flat_ = flat_shells(mesh_, element_, closed_neo_hookean(), angle_of_wale);
  double C10_ = closed_neo_hookean().params[0];

  /// Largest force (or moment) at the inner nodes.
  double inner(const Eigen::VectorXd& residual, bool moments) const {
    double result = 0.0;
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
      if (mesh_.boundary[i]) continue;
      const double force = residual.segment<3>(5 * i).norm(), moment = residual.segment<2>(5 * i + 3).norm();
      result = std::max(result, moments ? moment : force);
    }
    return result;
  }

  /// Tangent of the flat state times u [5 a node]: the element vectors, and the energy 1/2 u K u of all.
  std::pair<Eigen::VectorXd, double> linear_response(const Eigen::VectorXd& u) const {
    const Values values = evaluate(flat_);
    const int ndof = element_.ndof();
    Eigen::VectorXd forces(values.residual.size());
    double energy = 0.0;
    for (int e = 0; e < flat_.size(); ++e) {
      Eigen::VectorXd v(ndof);
      for (int i = 0; i < element_.nodes(); ++i) {
        v.segment<5>(5 * i) = u.segment<5>(5 * mesh_.connectivity[e * element_.nodes() + i]);
      }
      forces.segment(e * ndof, ndof) = values.tangent.middleRows(e * ndof, ndof) * v;
      energy += 0.5 * v.dot(forces.segment(e * ndof, ndof));
    }
    return {forces, energy};
  }
};

/// Elements without stabilisation.
class FullyIntegratedShellPatch : public ShellPatch {};

// A homogeneous stretch of a flat shell, inclined in space, has the energy of the membrane, its forces, and no moment;
// also with a frozen thickness that differs from the present one.
TEST_P(ShellPatch, HomogeneousStretchIsTheMembrane) {
  Eigen::Matrix<double, 3, 2> F;
  F << 1.35, 0.15, 0.05, 1.2, 0.0, 0.0;
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, 0.4, 0.2).normalized()));
  Eigen::VectorXd x(3 * mesh_.nodes.size());
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) x.segment<3>(3 * i) = Q * F * mesh_.nodes[i];
  const Values membrane = evaluate(gather(mesh_, membrane_, flat_.law, angle_of_wale, x));
  for (std::size_t k = 0; k < mesh_.connectivity.size(); ++k) {
    Eigen::Map<Eigen::Vector3d>(&flat_.x[5 * k]) = x.segment<3>(3 * mesh_.connectivity[k]);
    Eigen::Map<Eigen::Matrix3d>(&flat_.frames[9 * k]) = Q;
  }
  for (const bool refrozen : {false, true}) {
    if (refrozen) freeze(flat_);
    const Values shell = evaluate(flat_);
    EXPECT_LT((shell.energy - membrane.energy).cwiseAbs().maxCoeff(), 1e-12 * membrane.energy.maxCoeff());
    const double scale = membrane.residual.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < mesh_.connectivity.size(); ++k) {
      EXPECT_LT((shell.residual.segment<3>(5 * k) - membrane.residual.segment<3>(3 * k)).norm(), 1e-12 * scale);
      EXPECT_LT(shell.residual.segment<2>(5 * k + 3).norm(), 1e-12 * scale);
    }
    EXPECT_LT(inner(scatter_shells(mesh_, shell.residual), false), 1e-12 * scale);
  }
}

// Any plane deformation of a flat, fully integrated shell has the energy and the forces of the membrane.
TEST_P(FullyIntegratedShellPatch, PlaneDeformationIsTheMembrane) {
  Eigen::VectorXd x(3 * mesh_.nodes.size());
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
    const Eigen::Vector2d& X = mesh_.nodes[i];
    x.segment<3>(3 * i) << 1.3 * X[0] + std::sin(0.3 * X[1]), 1.2 * X[1] + std::cos(0.4 * X[0]), 0.0;
  }
  const Values membrane = evaluate(gather(mesh_, membrane_, flat_.law, angle_of_wale, x));
  for (std::size_t k = 0; k < mesh_.connectivity.size(); ++k) {
    Eigen::Map<Eigen::Vector3d>(&flat_.x[5 * k]) = x.segment<3>(3 * mesh_.connectivity[k]);
  }
  const Values shell = evaluate(flat_);
  EXPECT_LT((shell.energy - membrane.energy).cwiseAbs().maxCoeff(), 1e-12 * membrane.energy.maxCoeff());
  for (std::size_t k = 0; k < mesh_.connectivity.size(); ++k) {
    const Eigen::Vector3d force = membrane.residual.segment<3>(3 * k);
    EXPECT_LT((shell.residual.segment<3>(5 * k) - force).norm(), 1e-12 * membrane.residual.cwiseAbs().maxCoeff());
  }
}

// Constant curvature and twist of a flat distorted mesh, w = (k11 X^2 + k22 Y^2)/2 + k12 X Y with the directors normal
// to it: no force and no moment at inner nodes, and the energy of the plate 1/2 h^3/12 k.D k, to round-off.
TEST_P(ShellPatch, ConstantCurvatureIsExact) {
  const double k11 = 0.7, k22 = -0.4, k12 = 0.5;
  const Eigen::VectorXd u = constant_curvature(mesh_, k11, k22, k12);
  const auto [forces, energy] = linear_response(u);
  const Eigen::VectorXd residual = scatter_shells(mesh_, forces);
  const double scale = forces.cwiseAbs().maxCoeff(), h = flat_.thickness;
  EXPECT_GT(scale, 1e-4);
  EXPECT_LT(inner(residual, false), 1e-11 * scale);
  EXPECT_LT(inner(residual, true), 1e-11 * scale);
  // Incompressible and isotropic: D1111 = D2222 = 8 C10, D1122 = 4 C10, D1212 = 2 C10.
  const double plate = C10_ * (8.0 * (k11 * k11 + k22 * k22 + k11 * k22) + 8.0 * k12 * k12);
  EXPECT_NEAR(energy, 0.5 * plate * h * h * h / 12.0 * area, 1e-10 * energy);
}

// Constant transverse shear of a flat distorted mesh: the energy 1/2 G h gamma^2 A and no force at inner nodes, to
// round-off. Of triangles on a mesh that is fine against the thickness, without bending stiffness, whose round-off
// would hide the shear.
TEST_P(ShellPatch, ConstantTransverseShearIsExact) {
  const Eigen::Vector2d gamma(0.3, -0.2);
  if (element_.nodes() == 3) {
    flat_.layers = 1;
    flat_.thickness = 1e8;
  }
  const auto [forces, energy] = linear_response(constant_shear(mesh_, gamma));
  EXPECT_LT(inner(scatter_shells(mesh_, forces), false), 1e-12 * forces.cwiseAbs().maxCoeff());
  EXPECT_NEAR(energy, 0.5 * flat_.shear_modulus * flat_.thickness * gamma.squaredNorm() * area, 1e-12 * energy);
}

// The same of equal elements much larger than the thickness, where triangles soften the shear: to the compliance 1/(G
// h) comes a twentieth of L^2/(E h^3/12), L their longest edge.
TEST_P(ShellPatch, ConstantTransverseShearOfEqualElementsIsExact) {
  const Eigen::Vector2d gamma(0.3, -0.2);
  mesh_ = square_mesh(6, 30.0, 0.0, element_.nodes());
  flat_ = flat_shells(mesh_, element_, closed_neo_hookean(), angle_of_wale);
  const double h = flat_.thickness, bending = 6.0 * C10_ * h * h * h / 12.0;
  double compliance = 1.0 / (flat_.shear_modulus * h);
  if (element_.nodes() == 3) compliance += 0.05 * 50.0 / bending;
  const auto [forces, energy] = linear_response(constant_shear(mesh_, gamma));
  EXPECT_LT(inner(scatter_shells(mesh_, forces), false), 1e-12 * forces.cwiseAbs().maxCoeff());
  EXPECT_NEAR(energy, 0.5 / compliance * gamma.squaredNorm() * area, 1e-12 * energy);
}

// A cylinder as the reference, unrolled by the pattern: the reference areas add up to that of the facets, and
// flattening it to the pattern costs the bending energy of its curvature 1/R.
TEST_P(ShellPatch, FlattenedCylinderHasItsBendingEnergy) {
  const double R = 200.0, h = flat_.thickness;
  for (const int node : mesh_.connectivity) {
    const double angle = mesh_.nodes[node][0] / R;
    flat_.reference.insert(flat_.reference.end(), {R * std::sin(angle), mesh_.nodes[node][1], R * std::cos(angle) - R,
                                                   std::sin(angle), 0.0, std::cos(angle)});
  }
  Eigen::VectorXd areas(mesh_.connectivity.size());
  element_.reference_areas(flat_.batch(), areas.data());
  EXPECT_NEAR(areas.sum(), area, 1e-3 * area);
  EXPECT_GT(areas.minCoeff(), 0.0);
  const double plate = 0.5 * 8.0 * C10_ / (R * R) * h * h * h / 12.0 * area;
  flat_.layers = 1;  // membrane and transverse shear alone
  const double flattening = evaluate(flat_).energy.sum();
  flat_.layers = 3;
  EXPECT_NEAR(evaluate(flat_).energy.sum() - flattening, plate, 0.01 * plate);
}

INSTANTIATE_TEST_SUITE_P(All, ShellPatch, ::testing::ValuesIn(shells()),
                         [](const auto& test) { return std::string(test.param->name()); });

INSTANTIATE_TEST_SUITE_P(All, FullyIntegratedShellPatch, ::testing::Values(find("shell3"), find("shell4")),
                         [](const auto& test) { return std::string(test.param->name()); });

}  // namespace
}  // namespace toile::element::testing
