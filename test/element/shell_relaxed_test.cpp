// Shells of fabric whose fibres carry no compression: each layer is taut or slack by itself.
#include <gmock/gmock.h>

#include "shell_support.hpp"
#include "toile/material/relaxed_response.hpp"

namespace toile::element::testing {
namespace {

using material::WrinkleState;

Law slack_fibres(const char* name) {
  const material::LawV1& law = *material::find(name);
  for (const Law& known : laws())
    if (known.name.find(name) != std::string::npos)
      return {known.name, std::make_shared<material::RelaxedResponse>(law, material::Relaxation::slack_fibres, 1e-4),
              known.params};
  throw std::runtime_error(name);
}

class RelaxedShell : public ::testing::TestWithParam<const Element*> {
 protected:
  static constexpr int count = 40;

  /// Bent elements with stretches around one, so that some layers are taut and some slack.
  static Arrays bent(const Element& element, const char* law) {
    Arrays shells = random_shells(element, slack_fibres(law), count, 5, true);
    const int ndof = element.ndof();
    for (int k = 0; k < count * ndof; ++k)
      if (k % 5 < 3) shells.x[k] *= 0.78 + 0.12 * (k / ndof) / count;
    freeze(shells);
    return shells;
  }
  static Values moved(Arrays shells, int dof, double change) {
    for (int e = 0; e < shells.size(); ++e) shells.x[e * shells.element->ndof() + dof] += change;
    return evaluate(shells);
  }
};

std::string name_of(const ::testing::TestParamInfo<const Element*>& info) {
  return info.param->name();
}

// Residual and tangent are the exact derivatives of the relaxed energy (central differences, 1e-6 of the largest
// entry), with taut and slack points in the same batch.
TEST_P(RelaxedShell, DerivativesAreExact) {
  constexpr double step = 1e-5;
  for (const char* law : {"itskov", "isotropic-elastic"}) {
    const Arrays shells = bent(*GetParam(), law);
    const PointFields fields = GetParam()->fields(shells.batch());
    EXPECT_THAT(fields.wrinkle_state, ::testing::Contains(WrinkleState::taut));
    EXPECT_THAT(fields.wrinkle_state, ::testing::Contains(WrinkleState::wrinkled));
    const Values values = evaluate(shells);
    const int ndof = GetParam()->ndof();
    const double force = values.residual.cwiseAbs().maxCoeff(), stiffness = values.tangent.cwiseAbs().maxCoeff();
    EXPECT_GT(force, 1e-3);
    for (int dof = 0; dof < ndof; ++dof) {
      const Values above = moved(shells, dof, step), below = moved(shells, dof, -step);
      const Eigen::VectorXd slope = (above.energy - below.energy) / (2.0 * step);
      const Eigen::VectorXd column = (above.residual - below.residual) / (2.0 * step);
      for (int e = 0; e < count; ++e) EXPECT_NEAR(values.residual[e * ndof + dof], slope[e], 1e-6 * force) << law;
      EXPECT_LT((values.tangent.col(dof) - column).cwiseAbs().maxCoeff(), 1e-6 * stiffness) << law << " " << dof;
    }
  }
}

// Where fibres are slack the shell is softer than with fibres that carry compression, and nowhere stiffer.
TEST_P(RelaxedShell, StoresLessThanTheLaw) {
  Arrays shells = bent(*GetParam(), "itskov");
  const Eigen::VectorXd relaxed = evaluate(shells).energy;
  shells.law.response = std::make_shared<material::PlainResponse>(*material::find("itskov"));
  const Eigen::VectorXd full = evaluate(shells).energy;
  int softer = 0;
  for (int e = 0; e < count; ++e) {
    EXPECT_LE(relaxed[e], full[e] * (1.0 + 1e-12));
    softer += relaxed[e] < 0.99 * full[e];
  }
  EXPECT_GT(softer, count / 8);
}

// A layer that curvature turns inside out is refused, also by a fabric that admits any compression.
TEST_P(RelaxedShell, LayerTurnedInsideOutIsNotAdmissible) {
  const PlaneMesh mesh = square_mesh(1, 10.0, 0.0, GetParam()->nodes());
  Arrays flat = flat_shells(mesh, *GetParam(), slack_fibres("itskov"), 0.0);
  for (std::size_t k = 0; k < mesh.connectivity.size(); ++k)
    flat.x[5 * k + 3] = mesh.nodes[mesh.connectivity[k]][0] > 5.0 ? 0.5 : -0.5;
  const double slope = 1.0 / 10.0;  // p_1 = 1 + z d_1, with d_1 = slope at the outer layers' z
  flat.thickness = 1.8 / (std::sqrt(0.6) * slope);
  EXPECT_THAT(evaluate(flat).status, ::testing::Each(material::point_ok));
  flat.thickness = 2.2 / (std::sqrt(0.6) * slope);
  EXPECT_THAT(evaluate(flat).status, ::testing::Each(material::point_not_admissible));
}

INSTANTIATE_TEST_SUITE_P(All, RelaxedShell, ::testing::ValuesIn(shells()), name_of);

}  // namespace
}  // namespace toile::element::testing
