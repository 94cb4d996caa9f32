// Contact has room for a law with forces along the surface: one that is written here alone.
#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>

#include "coulomb.hpp"
#include "recorded.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

/// A strip laid round half of a rigid cylinder, held at its start and pulled along it at its end, which slides over it.
struct Capstan {
  static constexpr int along = 60;
  static constexpr double radius = 30.0, width = 3.0, angle = 3.0, pull_force = 0.01;  // mm, rad, N
  static constexpr double stretch = 1.01;                                              ///< with which it is laid on

  mesh::Mesh mesh;
  std::shared_ptr<material::Material> fabric = neo_hookean();
  Cylinder body{radius};
  solve::Problem problem;

  Capstan() {
    mesh::Block block;
    block.name = "strip";
    const int ranks = Tpetra::getDefaultComm()->getSize();
    const auto rank_of = [&](int j) { return std::min(ranks - 1, j * ranks / along); };
    solve::Support start{"start", {0, 1}, {true, true, true}, solve::Vec3::Zero()};
    solve::Support sides{"sides", {}, {false, false, true}, solve::Vec3::Zero()};
    const double chord = 2.0 * radius * std::sin(0.5 * angle / along);
    for (int j = 0; j <= along; ++j) {
      const double a = angle * j / along;
      for (int i = 0; i < 2; ++i) {
        const int node = 2 * j + i;
        mesh.pattern.emplace_back(chord * j / stretch, width * i);
        mesh.placed.emplace_back(radius * std::cos(a), radius * std::sin(a), width * i);
        problem.clusters.push_back({node});
        problem.cluster_rank.push_back(rank_of(std::max(0, j - 1)));
        if (j > 0) sides.nodes.push_back(node);
      }
    }
    problem.element_rank.emplace_back();
    for (int j = 0; j < along; ++j) {
      block.connectivity.insert(block.connectivity.end(), {2 * j, 2 * j + 2, 2 * j + 3, 2 * j + 1});
      block.wale_angle.push_back(0.0);
      block.position.push_back((j + 0.5) / along);
      problem.element_rank.back().push_back(rank_of(j));
    }
    mesh.blocks.push_back(block);
    mesh.panels.push_back({"strip", 0, mesh.nodes(), 1, {}});
    problem.mesh = &mesh;
    problem.models.push_back({element::find("membrane4"), fabric.get()});
    problem.supports = {start, sides};
    problem.surface = &body;
    problem.contact.offset_by_half_thickness = false;
    problem.loads.push_back(
        pull({2 * along, 2 * along + 1}, 0.5 * pull_force * solve::Vec3(-std::sin(angle), std::cos(angle), 0.0)));
  }

  /// What is left of the pull at the start, over the pull.
  double held_share() {
    // The force of friction follows the multiplier, which the tangent does not know: the solve converges linearly.
    solve::SolverOptions patient;
    patient.newton.max_iterations = 400;
    Recorded run(problem, patient);
    solve::State start = placed_state(problem);
    start.load = 1.0;
    run.simulation.set_start(start);
    run.simulation.run(stage("settle"));
    return run.last().balance.support[0].norm() / pull_force;
  }
};

// A rope round a capstan holds exp(-coefficient * angle) of the pull (Euler): 0.549 for 0.2 and 3 rad.
TEST(Friction, CapstanFollowsEuler) {
  Capstan capstan;
  capstan.problem.contact.law = std::make_shared<Coulomb>(0.2, 0.01);
  EXPECT_NEAR(capstan.held_share(), std::exp(-0.2 * Capstan::angle), 0.01);
}

// Without friction all of the pull arrives.
TEST(Friction, FrictionlessCapstanHoldsAll) {
  Capstan capstan;
  EXPECT_NEAR(capstan.held_share(), 1.0, 1e-3);
}

// The law's force is the gradient of its energy along the surface, and its tangent that of the force.
TEST(Friction, ForceIsTheGradientOfTheEnergy) {
  const Coulomb law(0.3, 0.05);
  constexpr double h = 1e-6, stiffness = 2.0;
  const contact::Vec3 start(0.1, -0.2, -0.3);
  const auto at = [&](const contact::Vec3& x) {  // the plane z = 0
    contact::Touch touch;
    touch.surface.gap = x[2];
    touch.surface.normal = contact::Vec3::UnitZ();
    touch.multiplier = 1.5;
    touch.stiffness = stiffness;
    touch.step = x - start;
    return law.evaluate(touch);
  };
  const contact::Vec3 x(0.16, -0.13, 0.02);
  const contact::NodeContact c = at(x);
  const contact::Mat3 hessian = c.tangent + stiffness * c.normal * c.normal.transpose();
  EXPECT_GT(c.residual.head<2>().norm(), 0.1);
  for (int i = 0; i < 3; ++i) {
    const contact::Vec3 d = h * contact::Vec3::Unit(i);
    EXPECT_NEAR((at(x + d).energy - at(x - d).energy) / (2.0 * h), c.residual[i], 1e-8) << i;
    EXPECT_LT(((at(x + d).residual - at(x - d).residual) / (2.0 * h) - hessian.col(i)).norm(), 1e-6) << i;
  }
}

}  // namespace
}  // namespace toile::test
