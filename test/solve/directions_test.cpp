// Supports along any direction.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "equilibrium/held.hpp"
#include "panels.hpp"
#include "recorded.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

using solve::Frame;
using solve::Support;
using solve::Vec3;

constexpr double degree = M_PI / 180.0;

/// The axes of space, turned.
Frame turned_axes(const Eigen::Matrix3d& rotation) {
  return rotation.transpose();
}

/// Holds some nodes in axes that are the columns of a rotation.
void hold(Panels& panel, const std::vector<int>& nodes, const std::array<bool, 3>& held, const Vec3& move,
          const Eigen::Matrix3d& rotation) {
  panel.hold_nodes(nodes, held);
  panel.problem.supports.back().displacement = move;
  if (!rotation.isIdentity(0.0)) panel.problem.supports.back().axes.assign(nodes.size(), turned_axes(rotation));
}

/// A strip that is pulled by 12 mm along its length, free to narrow, in a plane that is turned in space. Shells lie on
/// a plane of symmetry at their lower edge.
Panels strip(const char* formulation, const Eigen::Matrix3d& rotation) {
  Panels panel(pantyhose());
  panel.add(rotation * Vec3(2.0, 3.0, 0.0), rotation.col(0), rotation.col(1), 0);
  panel.mesh.normal.assign(static_cast<size_t>(Panels::nodes()), rotation.col(2));
  panel.problem.models[0] = {element::find(formulation), panel.material.get(), {3, 0.01, false}};
  std::vector<int> all, bottom, top;
  for (int n = 0; n < Panels::nodes(); ++n) all.push_back(n);
  for (int i = 0; i <= Panels::across; ++i) {
    bottom.push_back(Panels::node(0, i, 0));
    top.push_back(Panels::node(0, i, Panels::along));
  }
  hold(panel, bottom, {false, true, false}, Vec3::Zero(), rotation);
  hold(panel, top, {false, true, false}, Vec3(0.0, 12.0, 0.0), rotation);
  hold(panel, all, {false, false, true}, Vec3::Zero(), rotation);
  hold(panel, {Panels::node(0, 1, 0)}, {true, false, false}, Vec3::Zero(), rotation);
  if (panel.problem.models[0].is_shell()) panel.problem.supports[0].director = solve::DirectorSupport::symmetry;
  const int ranks = Tpetra::getDefaultComm()->getSize();
  const auto rank_of_row = [ranks](int j) { return std::min(j, Panels::along - 1) * ranks / Panels::along; };
  for (int n = 0; n < Panels::nodes(); ++n)
    panel.problem.cluster_rank[static_cast<size_t>(n)] = rank_of_row(n / (Panels::across + 1));
  for (int e = 0; e < Panels::across * Panels::along; ++e)
    panel.problem.element_rank[0][static_cast<size_t>(e)] = rank_of_row(e / Panels::across);
  return panel;
}

solve::StageOptions pulling() {
  solve::StageOptions s = stage("load");
  s.first_step = s.largest_step = 0.5;
  return s;
}

class Directions : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formulations, Directions, testing::Values("membrane4", "shell4"));

// A strip that lies at 30 degrees and out of the plane, held and pulled along its own directions, is the turned image
// of the strip along x and y: positions, reactions, energy and iterations.
TEST_P(Directions, ATurnedStripIsTheImageOfAStraightOne) {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(30.0 * degree, Vec3::UnitZ()) *
                                    Eigen::AngleAxisd(40.0 * degree, Vec3(1.0, 2.0, 0.5).normalized()))
                                       .toRotationMatrix();
  const Panels straight = strip(GetParam(), Eigen::Matrix3d::Identity()), turned = strip(GetParam(), rotation);
  Recorded a(straight.problem), b(turned.problem);
  a.simulation.run(pulling());
  b.simulation.run(pulling());
  ASSERT_GT(a.last().balance.support[1].y(), 0.1);
  EXPECT_EQ(a.last().iterations, b.last().iterations);
  EXPECT_NEAR(b.last().energy.strain, a.last().energy.strain, 1e-9 * a.last().energy.strain);
  for (size_t n = 0; n < a.simulation.state().position.size(); ++n)
    EXPECT_LT((b.simulation.state().position[n] - rotation * a.simulation.state().position[n]).norm(), 1e-8) << n;
  for (size_t s = 0; s < a.last().balance.support.size(); ++s)
    EXPECT_LT((b.last().balance.support[s] - rotation * a.last().balance.support[s]).norm(), 1e-9) << s;
  EXPECT_LT(b.last().balance.sum().norm(), 1e-9 * b.last().balance.magnitude);
}

// Two supports whose directions are at an angle of 50 degrees hold a node in their plane; each carries a force along
// its own direction, and together they carry what one support of the plane does.
TEST(ObliqueSupports, ShareTheForceOfTheirPlane) {
  const double angle = 50.0 * degree;
  const Vec3 slanted(std::cos(angle), std::sin(angle), 0.0), move(1.5, -2.0, 0.0);
  const auto corner_held = [&](bool obliquely) {
    Panels panel = strip("membrane4", Eigen::Matrix3d::Identity());
    panel.problem.supports.resize(3);
    const std::vector<int> corner{Panels::node(0, 2, 2)};
    if (obliquely) {
      hold(panel, corner, {true, false, false}, Vec3(move.x(), 0.0, 0.0), Eigen::Matrix3d::Identity());
      hold(panel, corner, {true, false, false}, Vec3(slanted.dot(move), 0.0, 0.0),
           Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix());
    } else {
      hold(panel, corner, {true, true, false}, move, Eigen::Matrix3d::Identity());
    }
    return panel;
  };
  const Panels plane = corner_held(false), oblique = corner_held(true);
  Recorded a(plane.problem), b(oblique.problem);
  a.simulation.run(pulling());
  b.simulation.run(pulling());
  const Vec3 whole = a.last().balance.support[3], first = b.last().balance.support[3],
             second = b.last().balance.support[4];
  ASSERT_GT(whole.norm(), 0.01);
  EXPECT_LT((first + second - whole).norm(), 1e-9);
  EXPECT_LT(first.cross(Vec3::UnitX()).norm(), 1e-12);
  EXPECT_LT(second.cross(slanted).norm(), 1e-12);
  for (size_t n = 0; n < a.simulation.state().position.size(); ++n)
    EXPECT_LT((b.simulation.state().position[n] - a.simulation.state().position[n]).norm(), 1e-8) << n;
  EXPECT_LT(b.last().balance.sum().norm(), 1e-9 * b.last().balance.magnitude);
}

/// What contradicts itself when node 0 is held along two directions, with movements along them.
std::optional<solve::Contradiction> contradiction(const Vec3& first, double first_move, const Vec3& second,
                                                  double second_move) {
  Panels panel(neo_hookean());
  panel.add(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 0);
  for (const auto& [direction, move] : {std::pair(first, first_move), std::pair(second, second_move)}) {
    const Eigen::Matrix3d rotation = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), direction).toRotationMatrix();
    hold(panel, {0}, {true, false, false}, Vec3(move, 0.0, 0.0), rotation);
  }
  solve::Held held;
  return hold_positions(panel.problem, {}, held);
}

// Supports of one direction must move alike, seen from either end of it; those of clearly different directions move as
// they like; directions that nearly agree are taken for a mistake.
TEST(ObliqueSupports, ContradictionsAreFound) {
  const Vec3 direction = Vec3(1.0, 2.0, 2.0) / 3.0, near = (direction + Vec3(0.01, 0.0, 0.0)).normalized();
  EXPECT_FALSE(contradiction(direction, 4.0, direction, 4.0));
  EXPECT_FALSE(contradiction(direction, 4.0, -direction, -4.0));
  EXPECT_FALSE(contradiction(direction, 4.0, Vec3::UnitX(), -7.0));
  const auto other = contradiction(direction, 4.0, -direction, 4.0);
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->nearly_parallel);
  EXPECT_NEAR(other->first_moves, -4.0, 1e-12);
  EXPECT_NEAR(other->second_moves, 4.0, 1e-12);
  const auto close = contradiction(direction, 0.0, near, 0.0);
  ASSERT_TRUE(close);
  EXPECT_TRUE(close->nearly_parallel);
}

// A fourth direction follows from the other three: it may be held if it moves as they do.
TEST(ObliqueSupports, ADependentDirectionMustMoveAsTheOthersDo) {
  for (const double move : {6.0, 5.0}) {
    Panels panel(neo_hookean());
    panel.add(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 0);
    hold(panel, {0}, {true, true, true}, Vec3(3.0, 3.0, 4.5), Eigen::Matrix3d::Identity());
    const Vec3 direction = Vec3(1.0, 2.0, 2.0) / 3.0;  // moves by 1 + 2 + 3
    hold(panel, {0}, {true, false, false}, Vec3(move, 0.0, 0.0),
         Eigen::Quaterniond::FromTwoVectors(Vec3::UnitX(), direction).toRotationMatrix());
    solve::Held held;
    EXPECT_EQ(hold_positions(panel.problem, {}, held).has_value(), move != 6.0);
  }
}

/// Rigid cone about z, r = 50 + z / 5.
class Cone : public body::Surface {
 public:
  static constexpr double slope = 0.2;
  body::SurfacePoint closest(const Vec3& p) const override {
    const double length = std::sqrt(1.0 + slope * slope), r = std::hypot(p[0], p[1]);
    const Vec3 out(p[0] / r, p[1] / r, 0.0), round(-out[1], out[0], 0.0);
    body::SurfacePoint s;
    s.gap = (r - 50.0 - slope * p[2]) / length;
    s.normal = (out - slope * Vec3::UnitZ()) / length;
    s.hessian = round * round.transpose() / (r * length);
    s.closest = p - s.gap * s.normal;
    s.found = true;
    return s;
  }
  double range() const override { return 50.0; }
  body::TriangleMesh triangles(double) const override { return {}; }
  std::string summary() const override { return "cone"; }
};

/// A sleeve on the cone between z = 10 and 70, its upper end held along the cone.
Sleeve sleeve_on_cone(int around, int along) {
  Sleeve::Options o = options(around, along);
  o.r0 = 48.0;
  o.l0 = 60.0;
  o.hold_top = false;
  Sleeve sleeve(o, neo_hookean());
  sleeve.surface = std::make_shared<Cone>();
  sleeve.problem.surface = sleeve.surface.get();
  sleeve.problem.contact.offset_by_half_thickness = false;
  Support& hem = sleeve.problem.supports.front();
  hem.nodes.clear();
  hem.held = {true, false, false};
  for (size_t n = 0; n < sleeve.mesh.placed.size(); ++n) {
    const double z = 10.0 + sleeve.mesh.pattern[n].y(), r = 50.0 + Cone::slope * z;
    Vec3& x = sleeve.mesh.placed[n];
    x = Vec3(x[0] / o.radius * r, x[1] / o.radius * r, z);
    sleeve.mesh.normal[n] = sleeve.surface->closest(x).normal;
    if (sleeve.mesh.pattern[n].y() < o.l0 - 1e-9) continue;
    const Vec3 normal = sleeve.mesh.normal[n], along_cone = (Vec3::UnitZ() - normal.z() * normal).normalized();
    Frame axes;
    axes << along_cone.transpose(), normal.cross(along_cone).transpose(), normal.transpose();
    hem.nodes.push_back(static_cast<int>(n));
    hem.axes.push_back(axes);
  }
  return sleeve;
}

// A sleeve that would slide down a cone hangs at its hem: the hem carries the axial part of the contact force, along
// the cone and not away from it, and the hem's own nodes press on the body like their neighbours: no part of the
// support's force is a pressure.
TEST(AlongTheLimb, AHemOnAConeCarriesTheAxialForceOfThePressure) {
  const Sleeve sleeve = sleeve_on_cone(32, 12);
  Recorded r(sleeve.problem);
  r.simulation.set_start(closed_start(sleeve.problem));
  r.simulation.run(stage("settle"));
  const solve::ForceBalance& balance = r.last().balance;
  const double axial = balance.support[0].z();
  ASSERT_GT(std::abs(axial), 0.05);
  EXPECT_NEAR(axial, -balance.contact.z(), 1e-8 * std::abs(axial));
  EXPECT_LT(balance.sum().norm(), 1e-8 * balance.magnitude);
  // The force along the cone has no part across it: radially, the nodes' forces are 1/5 of the axial ones.
  const solve::Fields fields = compute_fields(sleeve.problem, r.simulation.state());
  EXPECT_NEAR(contact_resultant(fields).z(), -axial, 1e-8 * std::abs(axial));
  // The pressure is recovered from tensions: its sum agrees within its error, 0.15 %.
  double pressed = 0.0;
  for (size_t n = 0; n < fields.pressure.size(); ++n)
    pressed += fields.pressure[n] * fields.area[n] * fields.normal[n].z();
  EXPECT_NEAR(pressed, -axial, 4e-3 * std::abs(axial));
}

// Over two meshes that force extrapolates (second order) to that of the smooth sleeve, which the first integral along
// the meridian (stretch times stress less energy is constant) gives by quadrature.
TEST(AlongTheLimb, AHemOnAConeCarriesTheForceOfTheSmoothSleeve) {
  double axial[2];
  for (const int fine : {0, 1}) {
    const Sleeve sleeve = sleeve_on_cone(32 << fine, 12 << fine);
    Recorded r(sleeve.problem);
    r.simulation.set_start(closed_start(sleeve.problem));
    r.simulation.run(stage("settle"));
    axial[fine] = r.last().balance.support[0].z();
  }
  constexpr double smooth = 0.694812565;  // N
  EXPECT_NEAR((4.0 * axial[1] - axial[0]) / 3.0, smooth, 1e-4 * smooth);
}

}  // namespace
}  // namespace toile::test
