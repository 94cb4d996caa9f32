#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "shell_support.hpp"

namespace toile::element::testing {
namespace {

class ShellModes : public ::testing::TestWithParam<std::tuple<const Element*, Law>> {
 protected:
  const Element& element_ = *std::get<0>(GetParam());
  const Law& law_ = std::get<1>(GetParam());
};

// The tangent of a free distorted element at rest, flat or curved, has exactly six zero eigenvalues, the rigid motions;
// all others are positive: there is no mode without energy.
TEST_P(ShellModes, OnlyRigidMotionsAreFree) {
  for (const bool curved : {false, true}) {
    const Arrays shells =
        at_rest(random_shells(element_, law_, 20, 17, curved), Eigen::Matrix3d::Identity(), {0, 0, 0});
    const Values values = evaluate(shells);
    const int ndof = element_.ndof();
    for (int e = 0; e < shells.size(); ++e) {
      const Eigen::MatrixXd K = values.tangent.middleRows(e * ndof, ndof);
      const Eigen::VectorXd modes = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
      EXPECT_LT(modes.head(6).cwiseAbs().maxCoeff(), 1e-12 * modes[ndof - 1]);
      EXPECT_GT(modes[6], 1e-6 * modes[ndof - 1]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShellModes,
                         ::testing::Combine(::testing::ValuesIn(shells()), ::testing::ValuesIn(laws())), case_name);

using Kinds = std::vector<const Element*>;

/// Strip of one row of `cells` cells along x, of the kinds in turn, every second cross edge skewed by up to `skew` of a
/// cell to either side. At x = 0 its deflection and its slope along x are held and nothing else, so that the
/// cross-section may curve across as a beam's does.
struct Cantilever {
  static constexpr double length = 1000.0, width = 50.0;
  Kinds kinds;
  std::vector<PlaneMesh> parts;  ///< [kind] on the same nodes

  Cantilever(int cells, double skew, const Kinds& in_turn) : kinds(in_turn) {
    std::vector<Eigen::Vector2d> nodes;
    for (int i = 0; i <= cells; ++i) {
      const double shift = i == 0 || i == cells ? 0.0 : (i % 2 ? skew : -skew);
      nodes.push_back({length * (i + shift) / cells, 0.0});
      nodes.push_back({length * (i - shift) / cells, width});
    }
    for (const Element* kind : kinds) parts.push_back({nodes, {}, {}, kind->nodes()});
    for (int i = 0; i < cells; ++i) {
      PlaneMesh& mesh = parts[i % parts.size()];
      const int a = 2 * i;
      const std::vector<int> quad = {a, a + 2, a + 3, a + 1}, halves = {a, a + 2, a + 3, a, a + 3, a + 1};
      const auto& cell = mesh.nodes_per_element == 4 ? quad : halves;
      mesh.connectivity.insert(mesh.connectivity.end(), cell.begin(), cell.end());
    }
  }

  /// Linear tip deflection under a force at the tip, over that of the beam without shear.
  double deflection(double thickness, double shear_modulus = 2.0 * closed_neo_hookean().params[0]) const {
    const double E = 6.0 * closed_neo_hookean().params[0];
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(5 * parts[0].nodes.size(), 5 * parts[0].nodes.size());
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      Arrays shells = flat_shells(parts[k], *kinds[k], closed_neo_hookean(), 0.0);
      shells.thickness = thickness;
      shells.shear_modulus = 5.0 / 6.0 * shear_modulus;
      add(parts[k], shells, K);
    }
    const int unknowns = static_cast<int>(K.rows());
    for (const int unknown : {0, 1, 2, 3, 5, 7, 8}) {
      K.row(unknown).setZero();
      K.col(unknown).setZero();
      K(unknown, unknown) = 1.0;
    }
    Eigen::VectorXd load = Eigen::VectorXd::Zero(unknowns);
    load[unknowns - 3] = load[unknowns - 8] = 0.5;
    const double beam = length * length * length / (3.0 * E * width * std::pow(thickness, 3) / 12.0);
    return K.ldlt().solve(load)[unknowns - 3] / beam;
  }

  static void add(const PlaneMesh& mesh, const Arrays& shells, Eigen::MatrixXd& K) {
    const Values values = evaluate(shells);
    const int nodes = mesh.nodes_per_element, ndof = 5 * nodes;
    for (int e = 0; e < shells.size(); ++e) {
      for (int i = 0; i < nodes; ++i) {
        for (int j = 0; j < nodes; ++j) {
          const int row = 5 * mesh.connectivity[e * nodes + i], column = 5 * mesh.connectivity[e * nodes + j];
          K.block<5, 5>(row, column) += values.tangent.block<5, 5>(e * ndof + 5 * i, 5 * j);
        }
      }
    }
  }
};

class ShellLocking : public ::testing::TestWithParam<Kinds> {};

// A cantilever of one row of 20 elements deflects within 0.2 % of beam theory in the thin limit, thickness 1e-3 and
// 1e-4 of the length: of quadrilaterals, of triangles, whose diagonals are all alike, and of both in turn, across whose
// borders the force goes.
TEST_P(ShellLocking, ThinCantileverBendsAsBeam) {
  const Cantilever strip(20, 0.0, GetParam());
  for (const double thickness : {1.0, 0.1}) EXPECT_NEAR(strip.deflection(thickness), 1.0, 0.002) << thickness;
}

// The same with every second cross edge skewed by a quarter of a cell to either side, within 0.5 %.
TEST_P(ShellLocking, SkewedCantileverBendsAsBeam) {
  const Cantilever strip(20, 0.25, GetParam());
  for (const double thickness : {1.0, 0.1}) EXPECT_NEAR(strip.deflection(thickness), 1.0, 0.005) << thickness;
}

// How much triangles soften their shear goes with their bending, not with the shear modulus: with one of a thousandth
// of Young's modulus the thin cantilever still bends as a beam, within 0.2 %.
TEST_P(ShellLocking, LittleShearModulusDoesNotSoftenBending) {
  const double E = 6.0 * closed_neo_hookean().params[0];
  EXPECT_NEAR(Cantilever(20, 0.0, GetParam()).deflection(0.1, 1e-3 * E), 1.0, 0.002);
}

INSTANTIATE_TEST_SUITE_P(All, ShellLocking,
                         ::testing::Values(Kinds{find("shell3")}, Kinds{find("shell4")}, Kinds{find("shell4r")},
                                           Kinds{find("shell4"), find("shell3")},
                                           Kinds{find("shell3"), find("shell4r")}),
                         [](const auto& test) {
                           std::string name;
                           for (const Element* kind : test.param)
                             name += (name.empty() ? "" : "_and_") + std::string(kind->name());
                           return name;
                         });

}  // namespace
}  // namespace toile::element::testing
