#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <thread>

#include "shell_support.hpp"

namespace toile::element::testing {
namespace {

class ShellInterface : public ::testing::TestWithParam<const Element*> {
 protected:
  const Element& element_ = *GetParam();
  Arrays elements_ = random_shells(element_, closed_neo_hookean(), 150, 9, true);
  int ndof_ = element_.ndof();
};

// A batch of several chunks gives the same numbers as its elements one by one, for any number of layers.
TEST_P(ShellInterface, BatchEqualsSingleElements) {
  for (const int layers : {1, 3, 5, 7}) {
    elements_.layers = layers;
    const Values batch = evaluate(elements_);
    for (int e = 0; e < elements_.size(); ++e) {
      const Arrays one = elements_.single(e);
      const Values single = evaluate(one);
      const Eigen::MatrixXd K = batch.tangent.middleRows(ndof_ * e, ndof_);
      EXPECT_NEAR(single.energy[0], batch.energy[e], 1e-13 * std::abs(batch.energy[e]));
      EXPECT_LT((single.residual - batch.residual.segment(ndof_ * e, ndof_)).norm(), 1e-13 * single.residual.norm());
      EXPECT_LT((single.tangent - K).norm(), 1e-13 * K.norm());
      Arrays again = one;
      freeze(again);
      EXPECT_THAT(again.frozen, ::testing::Pointwise(::testing::DoubleEq(), one.frozen));
    }
  }
}

// Parameters that vary from element to element reach the right element: with the shear modulus and the frozen moduli in
// proportion, forces scale with the C10 of the neo-Hookean.
TEST_P(ShellInterface, GraduatedParametersBelongToTheirElement) {
  elements_.shear_modulus = 0.0;
  const Values uniform = evaluate(elements_);
  for (int e = 0; e < elements_.size(); ++e) elements_.params.push_back(elements_.law.params[0] * (1.0 + e));
  freeze(elements_);
  const Values varied = evaluate(elements_);
  for (int e = 0; e < elements_.size(); ++e) {
    EXPECT_NEAR(varied.energy[e], (1.0 + e) * uniform.energy[e], 1e-12 * varied.energy[e]);
    const Eigen::VectorXd r = (1.0 + e) * uniform.residual.segment(e * ndof_, ndof_);
    EXPECT_LT((varied.residual.segment(e * ndof_, ndof_) - r).norm(), 1e-12 * r.norm());
  }
}

// What freeze() writes depends on the state alone, begins with the thickness stretch at each point, and is 1 at rest.
TEST_P(ShellInterface, FrozenThicknessIsTheMaterials) {
  const PointFields fields = element_.fields(elements_.batch());
  const std::vector<double> before = elements_.frozen;
  freeze(elements_);
  EXPECT_EQ(elements_.frozen, before);
  const Arrays rest = at_rest(elements_, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  const int points = element_.points(), values = element_.frozen_values();
  EXPECT_GE(values, points);
  for (int k = 0; k < elements_.size() * points; ++k) {
    const int at = k / points * values + k % points;
    EXPECT_DOUBLE_EQ(elements_.frozen[at], fields.thickness_stretch[k]);
    EXPECT_NEAR(rest.frozen[at], 1.0, 1e-13);
  }
}

// Bending a thinned shell costs less: the frozen stretch l scales the heights of the layers, so the bending stiffness
// of a flat shell goes with l^2.
TEST_P(ShellInterface, FrozenThicknessScalesBending) {
  const PlaneMesh mesh = square_mesh(1, 10.0, 0.0, element_.nodes());
  Arrays flat = flat_shells(mesh, element_, closed_neo_hookean(), 0.0);
  const auto bending = [&](double l) {
    for (int e = 0; e < flat.size(); ++e) {
      std::fill_n(flat.frozen.begin() + e * element_.frozen_values(), element_.points(), l);
    }
    flat.layers = 3;
    const Eigen::MatrixXd full = evaluate(flat).tangent;
    flat.layers = 1;
    return (full - evaluate(flat).tangent).eval();
  };
  const Eigen::MatrixXd thick = bending(1.0), thin = bending(0.5);
  EXPECT_GT(thick.norm(), 1e-4);
  EXPECT_LT((thin - 0.25 * thick).norm(), 1e-12 * thick.norm());
}

// An element whose deformation is not admissible (collapsed to a point) is NaN with its status; the others are not.
TEST_P(ShellInterface, CollapsedElementIsNaNAndNamed) {
  const int bad = 70;
  std::fill_n(elements_.x.begin() + bad * ndof_, ndof_, 1.0);
  freeze(elements_);
  EXPECT_THAT(elements_.frozen, ::testing::Each(::testing::Truly([](double value) { return std::isfinite(value); })));
  const Values values = evaluate(elements_);
  const PointFields fields = element_.fields(elements_.batch());
  for (int e = 0; e < elements_.size(); ++e) {
    EXPECT_EQ(values.status[e], e == bad ? material::point_not_admissible : material::point_ok);
    EXPECT_EQ(std::isnan(values.energy[e]), e == bad);
    EXPECT_EQ(values.residual.segment(e * ndof_, ndof_).array().isNaN().all(), e == bad);
    EXPECT_EQ(values.tangent.middleRows(e * ndof_, ndof_).array().isNaN().all(), e == bad);
    EXPECT_EQ(values.tangent.middleRows(e * ndof_, ndof_).array().isFinite().all(), e != bad);
    EXPECT_EQ(fields.status[e * element_.points()], values.status[e]);
    EXPECT_EQ(std::isnan(fields.S[3 * e * element_.points()]), e == bad);
  }
}

// A layer that curvature turns inside out makes the element NaN although its mid-surface is undeformed: the worst layer
// tells the status.
TEST_P(ShellInterface, WorstLayerTellsTheStatus) {
  const PlaneMesh mesh = square_mesh(1, 10.0, 0.0, element_.nodes());
  Arrays flat = flat_shells(mesh, element_, closed_neo_hookean(), 0.0);
  for (std::size_t k = 0; k < mesh.connectivity.size(); ++k) {  // p_1 = 1 + z d_1, -0.1 at an outer layer
    flat.x[5 * k + 3] = mesh.nodes[mesh.connectivity[k]][0] > 5.0 ? 1.5 : -1.5;
  }
  const double slope = 2.0 * std::sin(1.5) / 10.0;
  flat.thickness = 2.2 / (std::sqrt(0.6) * slope);
  EXPECT_THAT(evaluate(flat).status, ::testing::Each(material::point_not_admissible));
  EXPECT_TRUE(evaluate(flat).energy.array().isNaN().all());
  flat.layers = 1;
  EXPECT_THAT(evaluate(flat).status, ::testing::Each(material::point_ok));
}

// An element whose pattern is folded (nodes clockwise), or whose curved reference lies against its directors, is NaN
// with its status.
TEST_P(ShellInterface, FoldedReferenceIsNaNAndNamed) {
  Arrays against = elements_, folded = random_shells(element_, closed_neo_hookean(), 5, 9, false);
  for (std::size_t k = 0; k < folded.pattern.size(); k += 2) folded.pattern[k] *= -1.0;
  for (std::size_t k = 0; k < against.reference.size(); k += 6) {
    for (int c = 3; c < 6; ++c) against.reference[k + c] *= -1.0;
  }
  for (const Arrays& bad : {folded, against}) {
    const Values values = evaluate(bad);
    EXPECT_THAT(values.status, ::testing::Each(material::point_not_admissible));
    EXPECT_TRUE(values.residual.array().isNaN().all());
    const PointFields fields = element_.fields(bad.batch());
    EXPECT_THAT(fields.status, ::testing::Each(material::point_not_admissible));
    EXPECT_TRUE(std::isnan(fields.energy_density[0]) && std::isnan(fields.cauchy_principal[0]));
  }
}

// Output fields are those of the mid-surface: of a uniaxially stretched neo-Hookean strip they are exact, as for the
// membranes, and do not depend on the number of layers.
TEST_P(ShellInterface, FieldsOfUniaxialStretchAreExact) {
  const double l = 1.5, C10 = elements_.law.params[0], lateral = 1.0 / std::sqrt(l);
  Arrays flat = random_shells(element_, closed_neo_hookean(), 20, 4, false);
  for (std::size_t k = 0; k < flat.x.size() / 5; ++k) {
    flat.x[5 * k] = l * flat.pattern[2 * k];
    flat.x[5 * k + 1] = lateral * flat.pattern[2 * k + 1];
    flat.x[5 * k + 2] = 0.0;
  }
  for (const int layers : {1, 7}) {
    flat.layers = layers;
    const PointFields fields = element_.fields(flat.batch());
    ASSERT_EQ(fields.energy_density.size(), static_cast<std::size_t>(flat.size()) * element_.points());
    for (std::size_t k = 0; k < fields.energy_density.size(); ++k) {
      EXPECT_NEAR(fields.cauchy_principal[2 * k], 2.0 * C10 * (l * l - 1.0 / l), 1e-14);
      EXPECT_NEAR(fields.cauchy_principal[2 * k + 1], 0.0, 1e-14);
      EXPECT_NEAR(fields.thickness_stretch[k], lateral, 1e-13);
      EXPECT_NEAR(fields.energy_density[k], C10 * (l * l + 2.0 / l - 3.0), 1e-14);
      EXPECT_EQ(fields.status[k], material::point_ok);
    }
  }
}

// The wale direction of a curved reference is the image of the pattern's: on a cylinder unrolled by its pattern, whose
// axis lies along y, a stretch of the placed cylinder along its axis appears as the material frame at wale_angle says.
TEST_P(ShellInterface, CurvedReferenceCarriesTheWaleDirection) {
  const double R = 500.0, stretch = 1.2, angle = 0.4;
  const PlaneMesh mesh = square_mesh(3, 10.0, 0.2, element_.nodes());
  Arrays arrays = flat_shells(mesh, element_, closed_neo_hookean(), angle);
  for (std::size_t k = 0; k < mesh.connectivity.size(); ++k) {
    const Eigen::Vector2d X = mesh.nodes[mesh.connectivity[k]];
    const Eigen::Vector3d normal(std::sin(X[0] / R), 0.0, std::cos(X[0] / R));
    const Eigen::Vector3d place = R * normal + Eigen::Vector3d(0.0, X[1], 0.0);
    arrays.reference.insert(arrays.reference.end(), place.data(), place.data() + 3);
    arrays.reference.insert(arrays.reference.end(), normal.data(), normal.data() + 3);
    Eigen::Map<Eigen::Vector3d>(&arrays.x[5 * k]) << place[0], stretch * place[1], place[2];
  }
  const double s = std::sin(angle), c = std::cos(angle), more = stretch * stretch - 1.0;
  const double expected[3] = {1.0 + more * s * s, 1.0 + more * c * c, more * s * c};
  const PointFields fields = element_.fields(arrays.batch());
  for (std::size_t k = 0; k < fields.C.size(); ++k) EXPECT_NEAR(fields.C[k], expected[k % 3], 1e-4);
}

// Evaluations in several threads at once do not disturb each other.
TEST_P(ShellInterface, ThreadsAreIndependent) {
  const Values alone = evaluate(elements_);
  std::array<Values, 4> values;
  std::vector<std::thread> threads;
  for (Values& mine : values) {
    threads.emplace_back([&] {
      for (int repeat = 0; repeat < 10; ++repeat) mine = evaluate(elements_);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Values& mine : values) EXPECT_TRUE(mine.residual == alone.residual && mine.tangent == alone.tangent);
}

// Energy and residual do not depend on whether a tangent is asked for.
TEST_P(ShellInterface, TangentIsOptional) {
  const Values full = evaluate(elements_);
  Eigen::VectorXd energy(elements_.size()), residual(elements_.size() * ndof_);
  element_.evaluate(elements_.batch(), {energy.data(), residual.data(), nullptr, nullptr});
  EXPECT_TRUE(energy == full.energy && residual == full.residual);
}

// Nodal areas of a homogeneous stretch add up to the stretched area; a shell is found by its name.
TEST_P(ShellInterface, AreasAddUpAndNameIsFound) {
  const PlaneMesh mesh = square_mesh(4, 20.0, 0.2, element_.nodes());
  Arrays flat = flat_shells(mesh, element_, closed_neo_hookean(), 0.4);
  for (std::size_t k = 0; k < flat.x.size(); k += 5) flat.x[k] *= 1.5;
  Eigen::VectorXd areas(mesh.connectivity.size());
  element_.nodal_areas(flat.batch(), areas.data());
  EXPECT_NEAR(areas.sum(), 600.0, 1e-10);
  EXPECT_GT(areas.minCoeff(), 0.0);
  element_.reference_areas(flat.batch(), areas.data());
  EXPECT_NEAR(areas.sum(), 400.0, 1e-10);
  const auto n = static_cast<std::size_t>(element_.nodes());
  std::vector<double> products(n * mesh.connectivity.size());
  element_.gradient_products(flat.batch(), products.data());
  double energy = 0.0;  // of x = (1.5 X, Y): |F|^2 A
  for (std::size_t e = 0; e < mesh.connectivity.size() / n; ++e)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t c = 0; c < 3; ++c)
          energy += products[(n * e + i) * n + j] * flat.x[5 * (n * e + i) + c] * flat.x[5 * (n * e + j) + c];
  EXPECT_NEAR(energy, 400.0 * (1.5 * 1.5 + 1.0), 1e-9);
  EXPECT_EQ(find(element_.name()), &element_);
}

INSTANTIATE_TEST_SUITE_P(All, ShellInterface, ::testing::ValuesIn(shells()),
                         [](const auto& test) { return std::string(test.param->name()); });

}  // namespace
}  // namespace toile::element::testing
