#include <gmock/gmock.h>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;

// A scene that names only a panel uses no optional module and builds nothing for it.
TEST(Modules, AreLeftOutUnlessNamed) {
  const auto scene = build(flat_scene());
  EXPECT_THAT(scene->used(), IsEmpty());
  for (const char* name : {"body and contact", "seams", "sewing by continuation", "damping", "dead loads",
                           "graduated fabric", "partition", "shells", "follower pressure", "arc length continuation",
                           "stability at every step", "relaxed fabric", "turning supports"})
    EXPECT_THAT(scene->left_out(), Contains(name));
  EXPECT_EQ(scene->surface(), nullptr);
  EXPECT_EQ(scene->problem().surface, nullptr);
  EXPECT_EQ(scene->problem().clusters.size(), static_cast<size_t>(scene->garment().mesh.nodes()));
}

// Each module is used when the scene names it, and is then not among those left out.
TEST(Modules, AreUsedWhenNamed) {
  ParameterList list = tube_scene();
  add_sewing(list);
  ParameterList& load = list.sublist("Loads").sublist("pull");
  load.set("on", std::string("tube.top")).set("traction", reals({0, 0, 0.01}));
  ParameterList& table = list.sublist("Materials").sublist("knit").sublist("C10");
  table.set("position", reals({0, 1})).set("value", reals({0.01, 0.008}));
  const auto scene = build(list, 3);
  for (const char* name : {"body and contact", "seams", "sewing by continuation", "damping", "dead loads",
                           "graduated fabric", "partition"}) {
    EXPECT_THAT(scene->used(), Contains(name));
    EXPECT_THAT(scene->left_out(), Not(Contains(name)));
  }
}

// Fabric whose compression is relaxed is a module of its own.
TEST(Modules, RelaxedFabricIsUsedWhenNamed) {
  ParameterList list = flat_scene();
  list.sublist("Materials").sublist("knit").set("compression", std::string("tension field"));
  EXPECT_THAT(build(list)->used(), Contains("relaxed fabric"));
}

// On several ranks every rank gets elements, and each cluster belongs to a rank that has an element touching it.
TEST(Modules, PartitionGivesEachRankItsShare) {
  const auto scene = build(tube_scene(), 3);
  std::vector<int> elements(3, 0);
  for (const int rank : scene->problem().element_rank.at(0)) ++elements.at(static_cast<size_t>(rank));
  for (const int count : elements) EXPECT_GT(count, 0);
  EXPECT_EQ(scene->problem().cluster_rank.size(), scene->problem().clusters.size());
}

// Triangular panels get the triangular element.
TEST(Modules, ElementFollowsThePanel) {
  ParameterList list = flat_scene();
  list.sublist("Panels").sublist("tube").set("elements", std::string("triangle"));
  EXPECT_EQ(build(list)->problem().models.at(0).element, element::find("membrane3"));
  EXPECT_EQ(build(flat_scene())->problem().models.at(0).element, element::find("membrane4"));
}

}  // namespace
}  // namespace toile::scene::test
