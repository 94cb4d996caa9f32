#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <thread>

#include "support.hpp"
#include "toile/material/relaxed_response.hpp"

namespace toile::element::testing {
namespace {

class MembraneInterface : public ::testing::TestWithParam<const Element*> {
 protected:
  Arrays elements_ = random_elements(*GetParam(), closed_neo_hookean(), 100, 9);
  int ndof_ = GetParam()->ndof();
};

// Parameters that vary from element to element reach the right element: neo-Hookean forces scale with its C10.
TEST_P(MembraneInterface, GraduatedParametersBelongToTheirElement) {
  Arrays graduated = elements_;
  for (int e = 0; e < elements_.size(); ++e) graduated.params.push_back(elements_.law.params[0] * (1.0 + e));
  const Values uniform = evaluate(elements_), varied = evaluate(graduated);
  for (int e = 0; e < elements_.size(); ++e) {
    EXPECT_NEAR(varied.energy[e], (1.0 + e) * uniform.energy[e], 1e-12 * varied.energy[e]);
    const Eigen::VectorXd r = (1.0 + e) * uniform.residual.segment(e * ndof_, ndof_);
    EXPECT_LT((varied.residual.segment(e * ndof_, ndof_) - r).norm(), 1e-12 * r.norm());
  }
}

// An element whose deformation is not admissible (collapsed to a point) is NaN with its status; the others are not.
TEST_P(MembraneInterface, CollapsedElementIsNaNAndNamed) {
  const int bad = 70;
  std::fill_n(elements_.x.begin() + bad * ndof_, ndof_, 1.0);
  const Values values = evaluate(elements_);
  for (int e = 0; e < elements_.size(); ++e) {
    EXPECT_EQ(values.status[e], e == bad ? material::point_not_admissible : material::point_ok);
    EXPECT_EQ(std::isnan(values.energy[e]), e == bad);
    EXPECT_EQ(values.residual.segment(e * ndof_, ndof_).array().isNaN().all(), e == bad);
    EXPECT_EQ(values.tangent.middleRows(e * ndof_, ndof_).array().isNaN().all(), e == bad);
    EXPECT_EQ(values.tangent.middleRows(e * ndof_, ndof_).array().isFinite().all(), e != bad);
  }
}

// An element whose pattern is folded (nodes clockwise) is NaN with its status, whatever the material says.
TEST_P(MembraneInterface, FoldedPatternIsNaNAndNamed) {
  for (std::size_t k = 0; k < elements_.pattern.size(); k += 2) elements_.pattern[k] *= -1.0;
  const Values values = evaluate(elements_);
  EXPECT_THAT(values.status, ::testing::Each(material::point_not_admissible));
  EXPECT_TRUE(values.residual.array().isNaN().all());
  const PointFields fields = GetParam()->fields(elements_.batch());
  EXPECT_THAT(fields.status, ::testing::Each(material::point_not_admissible));
  EXPECT_TRUE(std::isnan(fields.energy_density[0]) && std::isnan(fields.cauchy_principal[0]));
}

/// The hand-written law, which remembers whether it was asked for a tangent.
class Spy final : public material::Response {
 public:
  mutable bool tangent_was_asked = false;

  int n_params() const override { return law_.n_params(); }
  int evaluate(int n, const double* C, const double* params, int stride, double* W, double* S, double* D,
               double* thickness, std::uint8_t* status) const override {
    tangent_was_asked = D != nullptr;
    return law_.evaluate(n, C, params, stride, W, S, D, thickness, status);
  }
  double natural_shear_modulus(const double* params) const override { return law_.natural_shear_modulus(params); }

 private:
  const material::Response& law_ = *closed_neo_hookean().response;
};

// Without a tangent the material is not asked for one, and energy and residual are those of the full evaluation.
TEST_P(MembraneInterface, TangentIsOnlyEvaluatedIfAsked) {
  const auto spy = std::make_shared<Spy>();
  elements_.law.response = spy;
  const Values full = evaluate(elements_);
  EXPECT_TRUE(spy->tangent_was_asked);
  Eigen::VectorXd energy(elements_.size()), residual(elements_.size() * ndof_);
  GetParam()->evaluate(elements_.batch(), {energy.data(), residual.data(), nullptr, nullptr});
  EXPECT_FALSE(spy->tangent_was_asked);
  EXPECT_TRUE(energy == full.energy && residual == full.residual);
}

// Output fields of a uniaxial stretch 1.5 of a neo-Hookean strip: sigma = mu (l^2 - 1/l), lateral stress zero,
// thickness stretch l^-1/2, W = C10 (l^2 + 2/l - 3), turned in space and against the material frame.
TEST_P(MembraneInterface, FieldsOfUniaxialStretchAreExact) {
  const double l = 1.5, C10 = elements_.law.params[0], lateral = 1.0 / std::sqrt(l);
  const Eigen::Vector3d along(0.6, 0.0, 0.8), across(0.0, 1.0, 0.0);
  for (std::size_t k = 0; k < elements_.x.size() / 3; ++k) {
    Eigen::Map<Eigen::Vector3d> x(elements_.x.data() + 3 * k);
    x = l * elements_.pattern[2 * k] * along + lateral * elements_.pattern[2 * k + 1] * across;
  }
  const PointFields fields = GetParam()->fields(elements_.batch());
  ASSERT_EQ(fields.energy_density.size(), static_cast<std::size_t>(elements_.size()) * GetParam()->points());
  for (std::size_t k = 0; k < fields.energy_density.size(); ++k) {
    EXPECT_NEAR(fields.cauchy_principal[2 * k], 2.0 * C10 * (l * l - 1.0 / l), 1e-14);
    EXPECT_NEAR(fields.cauchy_principal[2 * k + 1], 0.0, 1e-14);
    EXPECT_NEAR(fields.thickness_stretch[k], lateral, 1e-13);
    EXPECT_NEAR(fields.energy_density[k], C10 * (l * l + 2.0 / l - 3.0), 1e-14);
    EXPECT_EQ(fields.status[k], material::point_ok);
  }
}

// Elements of fabric with its course at half length wrinkle along the wale, which stands at 1 radian to the pattern and
// is turned in space; the same fabric without relaxation has no wrinkles to write.
TEST_P(MembraneInterface, CrestsOfWrinklesRunAlongTheTension) {
  const Eigen::Vector3d along(0.6, 0.0, 0.8), across(0.0, 1.0, 0.0);
  const double angle = 1.0, c = std::cos(angle), s = std::sin(angle);
  for (int e = 0; e < elements_.size(); ++e) elements_.wale_angle[e] = angle;
  for (std::size_t k = 0; k < elements_.x.size() / 3; ++k) {
    const double X = elements_.pattern[2 * k], Y = elements_.pattern[2 * k + 1];
    Eigen::Map<Eigen::Vector3d> x(elements_.x.data() + 3 * k);
    x = 1.4 * (c * X + s * Y) * along + 0.5 * (c * Y - s * X) * across;
  }
  EXPECT_TRUE(GetParam()->fields(elements_.batch()).wrinkle_state.empty());
  const auto& law = *material::find("neo-hookean");
  elements_.law.response = std::make_shared<material::RelaxedResponse>(law, material::Relaxation::tension_field, 1e-4);
  const PointFields fields = GetParam()->fields(elements_.batch());
  EXPECT_THAT(fields.wrinkle_state, ::testing::Each(material::WrinkleState::wrinkled));
  ASSERT_EQ(fields.wrinkle_state.size(), static_cast<std::size_t>(elements_.size()) * GetParam()->points());
  for (std::size_t k = 0; k < fields.wrinkle_state.size(); ++k) {
    const Eigen::Map<const Eigen::Vector3d> crest(fields.wrinkle_crest.data() + 3 * k);
    EXPECT_NEAR(std::abs(crest.dot(along)), 1.0, 1e-12);
    EXPECT_NEAR(crest.norm(), 1.0, 1e-14);
  }
}

// The output stress S is the one of the material at the output C.
TEST_P(MembraneInterface, FieldsStressBelongsToC) {
  const PointFields fields = GetParam()->fields(elements_.batch());
  for (std::size_t k = 0; k < fields.status.size(); ++k) {
    double W, S[3], thickness;
    std::uint8_t status;
    elements_.law.response->evaluate(1, &fields.C[3 * k], elements_.law.params.data(), 0, &W, S, nullptr, &thickness,
                                     &status);
    for (int q = 0; q < 3; ++q) EXPECT_DOUBLE_EQ(fields.S[3 * k + q], S[q]);
  }
}

// Evaluations in several threads at once do not disturb each other.
TEST_P(MembraneInterface, ThreadsAreIndependent) {
  const Values alone = evaluate(elements_);
  std::array<Values, 4> values;
  std::vector<std::thread> threads;
  for (Values& mine : values) {
    threads.emplace_back([&] {
      for (int repeat = 0; repeat < 50; ++repeat) mine = evaluate(elements_);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Values& mine : values) EXPECT_TRUE(mine.residual == alone.residual && mine.tangent == alone.tangent);
}

// An element is found by its name, and tells its sizes; an unknown name gives null.
TEST_P(MembraneInterface, RegistryFindsByName) {
  EXPECT_EQ(find(GetParam()->name()), GetParam());
  EXPECT_EQ(GetParam()->dofs_per_node(), 3);
  EXPECT_EQ(find("membrane5"), nullptr);
}

// Nodal areas of a curved element: a quarter of a unit bilinear saddle z = c X Y by 2 x 2 points within 1e-4 of the
// exact integral of N_1 sqrt(1 + c^2 (X^2 + Y^2)) by a fine midpoint rule.
TEST(Membrane4, NodalAreasOfSaddleAreIntegralOfShapeFunction) {
  const double c = 0.3;
  Arrays saddle;
  saddle.pattern = {0, 0, 1, 0, 1, 1, 0, 1};
  saddle.x = {0, 0, 0, 1, 0, 0, 1, 1, c, 0, 1, 0};
  saddle.wale_angle = {0.0};
  double areas[4], exact[4] = {};
  find("membrane4")->nodal_areas(saddle.batch(), areas);
  const int fine = 200;
  for (int k = 0; k < fine * fine; ++k) {
    const double X = (k % fine + 0.5) / fine, Y = (k / fine + 0.5) / fine;
    const double dA = std::sqrt(1.0 + c * c * (X * X + Y * Y)) / (fine * fine);
    const double N[4] = {(1 - X) * (1 - Y), X * (1 - Y), X * Y, (1 - X) * Y};
    for (int i = 0; i < 4; ++i) exact[i] += N[i] * dA;
  }
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(areas[i], exact[i], 1e-4);
  EXPECT_GT(areas[2] - areas[0], 1e-3);
}

INSTANTIATE_TEST_SUITE_P(All, MembraneInterface, ::testing::ValuesIn(membranes()),
                         [](const auto& test) { return std::string(test.param->name()); });

}  // namespace
}  // namespace toile::element::testing
