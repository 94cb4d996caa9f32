// The motion that a tangent resists least: found by every linear solver, and named where a stage fails.
#include "diagnosis/softest_motion.hpp"

#include <gmock/gmock.h>

#include "panels.hpp"
#include "recorded.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

using solve::Vec3;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two shells in the plane z = 0, sewn along one side. The first is held at all nodes; the second turns about the seam
/// as about a hinge, which no rigid motion of the whole garment is.
struct Hinged {
  Panels panels{neo_hookean()};
  int far_corner = 0;  ///< cluster: of the nodes furthest from the seam, all at 30 mm, the first

  Hinged() {
    const int ranks = Tpetra::getDefaultComm()->getSize();
    panels.add(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 0);
    panels.add(Vec3(Panels::across * Panels::size, 0.0, 0.0), Vec3::UnitX(), Vec3::UnitY(), ranks - 1);
    panels.make_shells(0.01);
    std::vector<std::vector<int>>& clusters = panels.problem.clusters;
    for (int j = Panels::along; j >= 0; --j) {
      clusters[Panels::node(0, Panels::across, j)].push_back(Panels::node(1, 0, j));
      clusters.erase(clusters.begin() + Panels::node(1, 0, j));
      panels.problem.cluster_rank.erase(panels.problem.cluster_rank.begin() + Panels::node(1, 0, j));
    }
    while (clusters[far_corner].front() != Panels::node(1, Panels::across, 0)) ++far_corner;
  }
  /// Holds the first panel, and whichever nodes of the second.
  solve::Held held(const std::vector<int>& of_second = {}) {
    std::vector<int> nodes = of_second;
    for (int n = 0; n < Panels::nodes(); ++n) nodes.push_back(n);
    panels.hold_nodes(nodes, {true, true, true});
    return find_held(panels.problem, placed_state(panels.problem), {});
  }
};

solve::SoftestMotion softest_of(const solve::Problem& problem, const solve::State& start, const solve::Held& held,
                                const std::string& method = "direct") {
  solve::SolverOptions options;
  options.linear.method = method;
  const double seam = start.seam;
  solve::Equilibrium equilibrium(problem, start, held, {0.0, 0.0, seam, seam}, options, Tpetra::getDefaultComm());
  const solve::Attempt attempt{equilibrium.start_vector(), 0.0, false, 0, {}};
  return softest_motion(equilibrium, attempt, problem.clusters.size());
}

// Of a panel that turns about a seam, every linear solver finds the node furthest from the seam, the direction across
// the panel, and no stiffness but round-off; on any number of ranks.
TEST(SoftestMotion, IsAHinge) {
  Hinged hinged;
  const solve::Held held = hinged.held();
  for (const char* method : {"direct", "cg", "gmres", "klu2"}) {
    const solve::SoftestMotion softest =
        softest_of(hinged.panels.problem, placed_state(hinged.panels.problem), held, method);
    ASSERT_TRUE(softest.is_free()) << method << ": " << softest.stiffness;
    EXPECT_LT(std::abs(softest.stiffness), 1e-13) << method;
    EXPECT_NEAR(softest.direction[2], 1.0, 1e-9) << method;
    EXPECT_EQ(softest.cluster, static_cast<size_t>(hinged.far_corner)) << method;
  }
}

// The same panel with a node held against turning is soft in bending, and not free.
TEST(SoftestMotion, IsNotFreeWhereItIsHeld) {
  Hinged hinged;
  const solve::SoftestMotion softest = softest_of(hinged.panels.problem, placed_state(hinged.panels.problem),
                                                  hinged.held({Panels::node(1, Panels::across, 2)}));
  ASSERT_TRUE(softest.found);
  EXPECT_FALSE(softest.is_free()) << softest.stiffness;
}

// A sleeve that nothing holds along its cylinder slides along it.
TEST(SoftestMotion, SlidesAlongACylinder) {
  const Sleeve sleeve(options(12, 6), neo_hookean());
  solve::Held held;
  held.position.resize(sleeve.problem.clusters.size());
  held.position[0][1] = {true, 0.0, 0.0, 0};  // against spinning: at (60, 0, 0) the direction round the body is y
  const solve::SoftestMotion softest = softest_of(sleeve.problem, closed_start(sleeve.problem), held);
  ASSERT_TRUE(softest.is_free()) << softest.stiffness;
  EXPECT_NEAR(softest.direction[2], 1.0, 1e-9);
}

/// The message of a stage that stretches the first panel up to the seam, in one step that is given one iteration.
std::string message_of(Hinged& hinged, const std::vector<int>& held_of_second) {
  solve::Problem& problem = hinged.panels.problem;
  std::vector<int> left, others = held_of_second;
  for (int j = 0; j <= Panels::along; ++j) {
    left.push_back(Panels::node(0, 0, j));
    others.push_back(Panels::node(0, Panels::across, j));
  }
  hinged.panels.hold_nodes(others, {true, true, true});
  hinged.panels.hold_nodes(left, {true, true, true});
  problem.supports.back().displacement = Vec3(-4.0, 0.0, 0.0);
  solve::SolverOptions solver;
  solver.newton.max_iterations = 1;
  Recorded run(problem, solver);
  run.simulation.set_start(placed_state(problem));
  solve::StageOptions whole = stage("load");
  whole.first_step = whole.smallest_step = whole.largest_step = 1.0;
  return failure_of(run.simulation, whole);
}

// The message of a stage that fails names the soft motion by node, panel and direction; where there is none, it says
// nothing of motions.
TEST(SoftestMotion, IsInTheMessageOfTheStage) {
  Hinged hinged, held;
  // The one iteration goes along the free motion as far as round-off has it, so whether the stresses there leave it a
  // stiffness, and of which sign, is not known.
  EXPECT_THAT(message_of(hinged, {}),
              HasSubstr(" a motion that is largest at node 24 of panel \"panel1\", at (60, 0, 0) mm, in the pattern "
                        "at (30, 0) mm, along (0, 0, 1)."));
  EXPECT_THAT(message_of(held, {Panels::node(1, Panels::across, 2)}), Not(HasSubstr("motion")));
}

}  // namespace
}  // namespace toile::test
