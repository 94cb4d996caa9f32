#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support.hpp"

namespace toile::element::testing {
namespace {

class MembranePatch : public ::testing::TestWithParam<std::tuple<const Element*, Law>> {
 protected:
  const Element& element_ = *std::get<0>(GetParam());
  const Law& law_ = std::get<1>(GetParam());
  PlaneMesh mesh_ = square_mesh(6, 30.0, 0.25, element_.nodes());
  Eigen::Matrix<double, 3, 2> F_ = homogeneous();

  /// Stretches 1.35 and 1.2, sheared, in a plane that is inclined in space.
  static Eigen::Matrix<double, 3, 2> homogeneous() {
    Eigen::Matrix<double, 3, 2> F;
    F << 1.35, 0.15, 0.05, 1.2, 0.0, 0.0;
    return Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, 0.4, 0.2).normalized()).toRotationMatrix() * F;
  }

  Arrays deformed(double wale_angle) const {
    Eigen::VectorXd x(3 * mesh_.nodes.size());
    for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) x.segment<3>(3 * i) = F_ * mesh_.nodes[i];
    return gather(mesh_, element_, law_, wale_angle, x);
  }
};

// A homogeneous deformation of a distorted mesh gives C = R^T F^T F R, wale 0.4 rad from the pattern's x axis and
// course 90 degrees counter-clockwise from it, at every point to round-off.
TEST_P(MembranePatch, HomogeneousDeformationGivesEqualC) {
  const double angle = 0.4;
  const Eigen::Vector2d wale(std::cos(angle), std::sin(angle)), course(-std::sin(angle), std::cos(angle));
  const double expected[3] = {(F_ * wale).squaredNorm(), (F_ * course).squaredNorm(), (F_ * wale).dot(F_ * course)};
  const PointFields fields = element_.fields(deformed(angle).batch());
  ASSERT_EQ(fields.C.size(), 3u * mesh_.elements() * element_.points());
  for (std::size_t k = 0; k < fields.C.size(); ++k) EXPECT_NEAR(fields.C[k], expected[k % 3], 1e-13);
}

// A homogeneous deformation of a distorted mesh is in equilibrium at every inner node to round-off.
TEST_P(MembranePatch, HomogeneousDeformationIsInEquilibrium) {
  const Values values = evaluate(deformed(0.4));
  const Eigen::VectorXd residual = scatter(mesh_, values.residual);
  const double scale = values.residual.cwiseAbs().maxCoeff();
  EXPECT_GT(scale, 1e-3);
  for (std::size_t i = 0; i < mesh_.nodes.size(); ++i) {
    if (mesh_.boundary[i]) continue;
    EXPECT_LT(residual.segment<3>(3 * i).norm(), 1e-13 * scale);
  }
}

// The energy of a homogeneous deformation is h0 W A.
TEST_P(MembranePatch, EnergyIsThicknessTimesDensityTimesArea) {
  const Arrays arrays = deformed(0.4);
  const double density = element_.fields(arrays.batch()).energy_density[0];
  EXPECT_GT(density, 1e-4);
  EXPECT_NEAR(evaluate(arrays).energy.sum(), arrays.thickness * density * 900.0, 1e-10 * density * 900.0);
}

// The reference areas of the nodes add up to the pattern's area, the current ones to |F_1 x F_2| times it.
TEST_P(MembranePatch, AreasAddUp) {
  const Arrays arrays = deformed(0.4);
  Eigen::VectorXd areas(mesh_.connectivity.size());
  element_.reference_areas(arrays.batch(), areas.data());
  EXPECT_NEAR(areas.sum(), 900.0, 1e-10);
  EXPECT_GT(areas.minCoeff(), 0.0);
  element_.nodal_areas(arrays.batch(), areas.data());
  EXPECT_NEAR(areas.sum(), 900.0 * F_.col(0).cross(F_.col(1)).norm(), 1e-10);
  EXPECT_GT(areas.minCoeff(), 0.0);
}

// The products of gradients are the energy of the map: of x = F X they sum to |F|^2 A, and of a constant to nothing.
TEST_P(MembranePatch, GradientProductsAreThoseOfTheMap) {
  const Arrays arrays = deformed(0.4);
  const auto n = static_cast<std::size_t>(element_.nodes());
  std::vector<double> products(n * mesh_.connectivity.size());
  element_.gradient_products(arrays.batch(), products.data());
  double energy = 0.0, of_constant = 0.0;
  for (std::size_t e = 0; e < mesh_.connectivity.size() / n; ++e)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double product = products[(n * e + i) * n + j];
        of_constant += product;
        for (std::size_t c = 0; c < 3; ++c)
          energy += product * arrays.x[3 * (n * e + i) + c] * arrays.x[3 * (n * e + j) + c];
      }
  EXPECT_NEAR(energy, 900.0 * F_.squaredNorm(), 1e-10 * energy);
  EXPECT_NEAR(of_constant, 0.0, 1e-10);
}

// Element-wise ("graduated") parameters that are constant give exactly the uniform result, over several chunks.
TEST_P(MembranePatch, ConstantGraduatedEqualsUniform) {
  const Arrays uniform = random_elements(element_, law_, 150, 3);
  Arrays graduated = uniform;
  for (int e = 0; e < uniform.size(); ++e) {
    graduated.params.insert(graduated.params.end(), law_.params.begin(), law_.params.end());
  }
  const Values a = evaluate(uniform), b = evaluate(graduated);
  EXPECT_LT((a.energy - b.energy).cwiseAbs().maxCoeff(), 1e-14 * a.energy.cwiseAbs().maxCoeff());
  EXPECT_LT((a.residual - b.residual).cwiseAbs().maxCoeff(), 1e-14 * a.residual.cwiseAbs().maxCoeff());
  EXPECT_LT((a.tangent - b.tangent).cwiseAbs().maxCoeff(), 1e-14 * a.tangent.cwiseAbs().maxCoeff());
}

// A batch of several chunks gives the same numbers as its elements one by one.
TEST_P(MembranePatch, BatchEqualsSingleElements) {
  const Arrays all = random_elements(element_, law_, 150, 5);
  const Values batch = evaluate(all);
  const int ndof = element_.ndof();
  for (int e = 0; e < all.size(); ++e) {
    const Values single = evaluate(all.single(e));
    EXPECT_NEAR(single.energy[0], batch.energy[e], 1e-13 * std::abs(batch.energy[e]));
    const Eigen::MatrixXd K = batch.tangent.middleRows(ndof * e, ndof);
    EXPECT_LT((single.residual - batch.residual.segment(ndof * e, ndof)).norm(), 1e-13 * single.residual.norm());
    EXPECT_LT((single.tangent - K).norm(), 1e-13 * K.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(All, MembranePatch,
                         ::testing::Combine(::testing::ValuesIn(membranes()), ::testing::ValuesIn(laws())), case_name);

}  // namespace
}  // namespace toile::element::testing
