// What keeps slack fabric where a stage finds it.
#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>
#include <cmath>

#include "equilibrium/equilibrium.hpp"
#include "panels.hpp"
#include "recorded.hpp"
#include "slack_panel.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

/// Cuts each quadrilateral of the panel into two triangles.
void cut(Panels& panels) {
  mesh::Block& block = panels.mesh.blocks.front();
  mesh::Block triangles = block;
  triangles.nodes_per_element = 3;
  triangles.connectivity.clear();
  triangles.wale_angle.assign(2 * static_cast<size_t>(block.size()), 0.0);
  triangles.position.assign(triangles.wale_angle.size(), 0.5);
  for (size_t e = 0; e < static_cast<size_t>(block.size()); ++e)
    for (const size_t corner : {0, 1, 2, 0, 2, 3}) triangles.connectivity.push_back(block.connectivity[4 * e + corner]);
  block = triangles;
  panels.problem.models.front().element = element::find("membrane3");
  panels.problem.element_rank.front().assign(triangles.wale_angle.size(), 0);
}

// Slack fabric stays where it is placed, without a force, and that is stable.
TEST(ResidualStiffness, SlackFabricStaysWhereItIs) {
  const Panels panels = slack_panel();
  Recorded run(panels.problem);
  run.simulation.run(stage("settle"));
  EXPECT_LE(run.last().iterations, 1);
  EXPECT_EQ(run.last().negative_pivots, 0);
  EXPECT_LT(run.last().balance.support[0].norm(), 1e-15);
  for (size_t n = 0; n < panels.mesh.placed.size(); ++n)
    EXPECT_LT((run.states.back().position[n] - panels.mesh.placed[n]).norm(), 1e-12);
}

// One side of a slack panel is moved in a step: it follows evenly, and the force is eps D0 h0 times the pattern's width
// over its length times the way, with D0 = 8 C10 of undeformed neo-Hookean fabric; of quadrilaterals and of triangles.
// The final state is the same without a force.
TEST(ResidualStiffness, ResistsUnevenMotion) {
  const solve::Vec3 way(-1.0, 2.0, 4.0);
  for (const bool triangles : {false, true}) {
    Panels panels = slack_panel();
    if (triangles) cut(panels);
    panels.problem.supports[1].displacement = way;
    Recorded run(panels.problem);
    solve::StageOptions whole = stage("load");
    whole.first_step = whole.largest_step = 1.0;
    run.simulation.run(whole);
    const double stiffness =
        slack_fabric::residual * 8.0 * slack_fabric::C10 * slack_fabric::thickness * Panels::along / Panels::across;
    const solve::StepReport& step = run.reports[run.reports.size() - 2];
    EXPECT_EQ(step.load, 1.0);
    EXPECT_LT((step.balance.support[1] - stiffness * way).norm(), 1e-9 * stiffness * way.norm());
    EXPECT_LT(run.last().balance.support[1].norm(), 1e-9 * stiffness * way.norm());
    for (int j = 0; j <= Panels::along; ++j)
      for (int i = 0; i <= Panels::across; ++i) {
        const size_t n = static_cast<size_t>(Panels::node(0, i, j));
        const solve::Vec3 expected = panels.mesh.placed[n] + way * i / Panels::across;
        EXPECT_LT((run.states.back().position[n] - expected).norm(), 1e-8);
      }
  }
}

// Fabric that was moved and is let go stays.
TEST(ResidualStiffness, CountsFromWhereTheFabricIs) {
  Panels panels = slack_panel();
  panels.problem.supports[1].displacement = {-1.0, 2.0, 4.0};
  Recorded run(panels.problem);
  run.simulation.run(stage("load"));
  const solve::State moved = run.states.back();
  solve::StageOptions free = stage("settle");
  free.released = {panels.problem.supports[1].name};
  run.simulation.run(free);
  for (size_t n = 0; n < moved.position.size(); ++n)
    EXPECT_LT((run.states.back().position[n] - moved.position[n]).norm(), 1e-9);
}

// Its force is the gradient of its potential, and its tangent the derivative of the force, wherever the fabric is.
TEST(ResidualStiffness, DerivativesBelongTogether) {
  const Panels panels = slack_panel();
  const solve::State start = placed_state(panels.problem);
  solve::Equilibrium equilibrium(panels.problem, start, find_held(panels.problem, start, {}), {0.0, 1.0, 0.0, 1.0},
                                 solve::SolverOptions(), Tpetra::getDefaultComm());
  const auto noise = [&](double size, int seed) {
    const auto v = Teuchos::rcp(new solve::Vector(equilibrium.map()));
    auto data = v->getDataNonConst();
    for (int i = 0; i < static_cast<int>(data.size()); ++i)
      data[i] = size * std::sin(12.9898 * (static_cast<double>(v->getMap()->getGlobalElement(i)) + 1.0) * seed);
    return v;
  };
  const auto z = equilibrium.start_vector(), direction = noise(1.0, 2);
  z->update(6.0, *noise(1.0, 1), 1.0);
  solve::Vector force(equilibrium.map()), product(equilibrium.map()), plus(equilibrium.map()), minus(equilibrium.map());
  equilibrium.residual(*z, 1.0, force);
  equilibrium.tangent().seek_minimum(false);
  equilibrium.linearise(*z, 1.0);
  equilibrium.apply(*direction, product);
  const double h = 1e-6;
  solve::Vector above(*z, Teuchos::Copy), below(*z, Teuchos::Copy);
  above.update(h, *direction, 1.0);
  below.update(-h, *direction, 1.0);
  const double slope = (equilibrium.energy(above, *z, 1.0) - equilibrium.energy(below, *z, 1.0)) / (2.0 * h);
  EXPECT_NEAR(slope, force.dot(*direction), 1e-6 * std::abs(slope));
  equilibrium.residual(above, 1.0, plus);
  equilibrium.residual(below, 1.0, minus);
  plus.update(-1.0, minus, 1.0);
  plus.scale(0.5 / h);
  plus.update(-1.0, product, 1.0);
  EXPECT_LT(plus.norm2(), 1e-6 * product.norm2());
}

}  // namespace
}  // namespace toile::test
