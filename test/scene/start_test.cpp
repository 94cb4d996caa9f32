#include "lists.hpp"

namespace toile::scene::test {
namespace {

// A scene that sews starts with open seams, every node where its panel was placed.
TEST(Start, IsOpenIfAStageSews) {
  ParameterList list = tube_scene();
  add_sewing(list);
  const auto scene = build(list);
  const solve::State start = scene->start();
  EXPECT_EQ(start.seam, 0.0);
  const solve::Problem& problem = scene->problem();
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c])
      EXPECT_LT((solve::node_position(problem, start, static_cast<int>(c), node) - problem.mesh->placed[node]).norm(),
                1e-12);
}

// A scene that does not sew starts with closed seams: both nodes of a pair are in the middle between their places.
TEST(Start, IsClosedIfNoStageSews) {
  const auto scene = build(tube_scene());
  const solve::State start = scene->start();
  EXPECT_EQ(start.seam, 1.0);
  const solve::Problem& problem = scene->problem();
  int pairs = 0;
  for (size_t c = 0; c < problem.clusters.size(); ++c) {
    const std::vector<int>& members = problem.clusters[c];
    if (members.size() < 2) continue;
    ++pairs;
    const solve::Vec3 middle = 0.5 * (problem.mesh->placed[members[0]] + problem.mesh->placed[members[1]]);
    for (const int node : members)
      EXPECT_LT((solve::node_position(problem, start, static_cast<int>(c), node) - middle).norm(), 1e-12);
  }
  EXPECT_EQ(pairs, 5);
}

}  // namespace
}  // namespace toile::scene::test
