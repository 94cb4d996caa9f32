// Triangles and quadrilaterals in one mesh: what each reproduces exactly, both do together.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "shell_support.hpp"

namespace toile::element::testing {
namespace {

constexpr int cells = 6;
constexpr double length = 30.0;
constexpr double angle_of_wale = 0.4;

/// The two kinds on the nodes of a distorted grid: each cell is a quadrilateral or is cut along one of its diagonals,
/// as chance has it, so that borders run in all directions.
struct MixedMesh {
  PlaneMesh quadrilaterals = square_mesh(cells, length, 0.25, 4);
  PlaneMesh triangles = square_mesh(cells, length, 0.25, 3);

  MixedMesh() {
    std::mt19937 random(3);
    const std::vector<int> all = quadrilaterals.connectivity;
    quadrilaterals.connectivity.clear();
    triangles.connectivity.clear();
    for (std::size_t k = 0; k < all.size(); k += 4) {
      const int a = all[k], b = all[k + 1], c = all[k + 2], d = all[k + 3];
      const unsigned chance = random() % 4;
      const std::vector<int> one = {a, b, c, a, c, d}, other = {a, b, d, b, c, d}, whole = {a, b, c, d};
      const std::vector<int>& cut = chance == 0 ? one : other;
      auto& into = chance < 2 ? triangles.connectivity : quadrilaterals.connectivity;
      const std::vector<int>& cell = chance < 2 ? cut : whole;
      into.insert(into.end(), cell.begin(), cell.end());
    }
  }
  const std::vector<Eigen::Vector2d>& nodes() const { return triangles.nodes; }
  bool is_inner(std::size_t node) const { return !triangles.boundary[node]; }
};

/// Gradient and tangent of all elements.
struct System {
  Eigen::VectorXd residual;
  Eigen::MatrixXd tangent;

  explicit System(Eigen::Index unknowns)
      : residual(Eigen::VectorXd::Zero(unknowns)), tangent(Eigen::MatrixXd::Zero(unknowns, unknowns)) {}
  void add(const PlaneMesh& mesh, const Arrays& arrays) {
    const Values values = evaluate(arrays);
    const int per_node = arrays.element->dofs_per_node(), per = mesh.nodes_per_element, ndof = per * per_node;
    for (int e = 0; e < arrays.size(); ++e) {
      for (int i = 0; i < per; ++i) {
        const int row = per_node * mesh.connectivity[e * per + i];
        residual.segment(row, per_node) += values.residual.segment(e * ndof + per_node * i, per_node);
        for (int j = 0; j < per; ++j) {
          tangent.block(row, per_node * mesh.connectivity[e * per + j], per_node, per_node) +=
              values.tangent.block(e * ndof + per_node * i, per_node * j, per_node, per_node);
        }
      }
    }
  }
  /// Change of the unknowns in `free` that brings them to equilibrium; the others stay.
  Eigen::VectorXd step(const std::vector<int>& free) const {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(residual.size());
    change(free) = -tangent(free, free).fullPivLu().solve(residual(free));
    return change;
  }
};

class MixedMembranePatch : public ::testing::TestWithParam<Law> {};

// With the edge of a distorted mesh of triangles and quadrilaterals on a homogeneous deformation (stretches 1.35 and
// 1.2, sheared, inclined in space, the fabric turned in the pattern), Newton's method brings all inner nodes onto it
// from a start away from it in and out of the plane, and C is the same at every point, both to round-off.
TEST_P(MixedMembranePatch, LargeHomogeneousDeformationIsFound) {
  const MixedMesh mesh;
  Eigen::Matrix<double, 3, 2> F;
  F << 1.35, 0.15, 0.05, 1.2, 0.0, 0.0;
  F = Eigen::AngleAxisd(0.8, Eigen::Vector3d(1.0, 0.4, 0.2).normalized()).toRotationMatrix() * F;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> away(-0.3, 0.3);
  const auto count = static_cast<Eigen::Index>(mesh.nodes().size());
  Eigen::VectorXd exact(3 * count), x;
  std::vector<int> free;
  for (Eigen::Index i = 0; i < count; ++i) exact.segment<3>(3 * i) = F * mesh.nodes()[i];
  x = exact;
  for (int k = 0; k < 3 * count; ++k) {
    if (!mesh.is_inner(k / 3)) continue;
    free.push_back(k);
    x[k] += away(random);
  }
  const auto arrays = [&](const PlaneMesh& part) {
    return gather(part, *find(part.nodes_per_element == 4 ? "membrane4" : "membrane3"), GetParam(), angle_of_wale, x);
  };
  for (int iteration = 0; iteration < 12; ++iteration) {
    System system(3 * count);
    for (const PlaneMesh* part : {&mesh.quadrilaterals, &mesh.triangles}) system.add(*part, arrays(*part));
    x += system.step(free);
  }
  EXPECT_LT((x - exact).cwiseAbs().maxCoeff(), 1e-12 * length);
  const Eigen::Vector2d wale(std::cos(angle_of_wale), std::sin(angle_of_wale)), course(-wale[1], wale[0]);
  const double C[3] = {(F * wale).squaredNorm(), (F * course).squaredNorm(), (F * wale).dot(F * course)};
  for (const PlaneMesh* part : {&mesh.quadrilaterals, &mesh.triangles}) {
    const Arrays found = arrays(*part);
    const PointFields fields = found.element->fields(found.batch());
    EXPECT_GT(fields.C.size(), 30u);
    for (std::size_t k = 0; k < fields.C.size(); ++k) EXPECT_NEAR(fields.C[k], C[k % 3], 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(All, MixedMembranePatch, ::testing::ValuesIn(laws()), [](const auto& test) {
  std::string name = test.param.name;
  for (char& letter : name) letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
  return name;
});

/// Laws whose tangent is continuous at rest, an isotropic and an orthotropic one.
std::vector<Law> smooth_laws() {
  std::vector<Law> some;
  for (const Law& law : laws())
    if (law.name == closed_neo_hookean().name || law.name == "itskov") some.push_back(law);
  return some;
}

/// Triangles and one kind of quadrilateral.
class MixedShellPatch : public ::testing::TestWithParam<std::tuple<const Element*, Law>> {
 protected:
  MixedMesh mesh_;
  double thickness_ = 0.8;  // a sixth of a side
  int layers_ = 3;

  /// Largest error of inner nodes over their largest unknown, where their unknowns `first` to `last` are free and all
  /// others follow u.
  double error(const Eigen::VectorXd& u, int first, int last) const {
    System system(u.size());
    for (const PlaneMesh* part : {&mesh_.quadrilaterals, &mesh_.triangles}) {
      const Element& element = part->nodes_per_element == 4 ? *std::get<0>(GetParam()) : *find("shell3");
      Arrays shells = flat_shells(*part, element, std::get<1>(GetParam()), angle_of_wale);
      shells.thickness = thickness_;
      shells.layers = layers_;
      system.add(*part, shells);
    }
    std::vector<int> free;
    for (int k = 0; k < u.size(); ++k)
      if (mesh_.is_inner(k / 5) && k % 5 >= first && k % 5 <= last) free.push_back(k);
    Eigen::VectorXd start = u;
    start(free).setZero();
    system.residual = system.tangent * start;
    const Eigen::VectorXd found = start + system.step(free);
    return (found - u).cwiseAbs().maxCoeff() / u(free).cwiseAbs().maxCoeff();
  }
};

// Linear membrane patch test: constant strains across the borders of triangles and quadrilaterals.
TEST_P(MixedShellPatch, ConstantStretchCrossesBorders) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(5 * mesh_.nodes().size());
  Eigen::Matrix2d gradient;
  gradient << 0.3, -0.2, 0.5, 0.1;
  for (std::size_t i = 0; i < mesh_.nodes().size(); ++i) u.segment<2>(5 * i) = gradient * mesh_.nodes()[i];
  EXPECT_LT(error(u, 0, 4), 1e-10);
}

// Linear bending patch test: constant curvature and twist across these borders, elements larger than the thickness.
TEST_P(MixedShellPatch, ConstantCurvatureCrossesBorders) {
  EXPECT_LT(error(constant_curvature(mesh_.triangles, 0.7, -0.4, 0.5), 0, 4), 1e-10);
}

// Linear shear patch test, the rotations given: constant transverse shear across these borders, the mesh fine against
// the thickness, where triangles do not soften it.
TEST_P(MixedShellPatch, ConstantTransverseShearCrossesBorders) {
  thickness_ = 1e8;
  layers_ = 1;
  EXPECT_LT(error(constant_shear(mesh_.triangles, {0.3, -0.2}), 0, 2), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(All, MixedShellPatch,
                         ::testing::Combine(::testing::Values(find("shell4"), find("shell4r")),
                                            ::testing::ValuesIn(smooth_laws())),
                         case_name);

}  // namespace
}  // namespace toile::element::testing
