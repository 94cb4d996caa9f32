#include "toile/garment/seam.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lists.hpp"
#include "toile/garment/garment.hpp"

namespace toile::garment {
namespace {

using test::add_rectangle;
using test::add_seam;
using test::input_error;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

Garment build(const Teuchos::ParameterList& panels, const Teuchos::ParameterList& seams) {
  const base::List list = base::validate(seams, seams_spec(), "scene.xml");
  return build_garment(base::validate(panels, panels_spec(), "scene.xml"), &list, nullptr);
}

/// Panels "front" and "back", 2 x 3 elements each.
Teuchos::ParameterList two_panels(double back_height = 30.0, int back_along = 3) {
  Teuchos::ParameterList panels;
  add_rectangle(panels, "front", 20.0, 30.0, 2, 3);
  add_rectangle(panels, "back", 20.0, back_height, 2, back_along);
  return panels;
}

// The nodes of two edges are paired one by one from bottom to top.
TEST(Seam, PairsNodeByNode) {
  Teuchos::ParameterList seams;
  add_seam(seams, "side", "front.right", "back.left");
  const Garment garment = build(two_panels(), seams);
  ASSERT_EQ(garment.seams.size(), 1u);
  EXPECT_EQ(garment.seams[0].name, "side");
  EXPECT_EQ(garment.seams[0].first, "front.right");
  EXPECT_EQ(garment.seams[0].second, "back.left");
  EXPECT_THAT(garment.seams[0].pairs, ElementsAre(Pair(2, 12), Pair(5, 15), Pair(8, 18), Pair(11, 21)));
}

// A reversed seam pairs the start of one edge with the end of the other.
TEST(Seam, ReversedRunsBackwards) {
  Teuchos::ParameterList seams;
  add_seam(seams, "side", "front.right", "back.right").set("reversed", true);
  EXPECT_THAT(build(two_panels(), seams).seams[0].pairs,
              ElementsAre(Pair(2, 23), Pair(5, 20), Pair(8, 17), Pair(11, 14)));
}

// A panel sewn to itself becomes a tube: each node of one side is tied to the other side.
TEST(Seam, TubeIsSewnToItself) {
  Teuchos::ParameterList panels, seams;
  add_rectangle(panels, "leg", 20.0, 30.0, 4, 3);
  add_seam(seams, "back", "leg.left", "leg.right");
  const Garment garment = build(panels, seams);
  EXPECT_THAT(garment.seams[0].pairs, ElementsAre(Pair(0, 4), Pair(5, 9), Pair(10, 14), Pair(15, 19)));
  EXPECT_EQ(garment.clusters.members.size(), 16u);
  EXPECT_EQ(garment.clusters.of_node[4], garment.clusters.of_node[0]);
  EXPECT_EQ(garment.clusters.master(9), 5);
}

// A dart between two edges that share a corner does not tie the corner to itself.
TEST(Seam, SharedCornerIsNotPaired) {
  Teuchos::ParameterList panels, seams;
  add_rectangle(panels, "patch", 20.0, 20.0, 2, 2);
  add_seam(seams, "dart", "patch.bottom", "patch.left");
  EXPECT_THAT(build(panels, seams).seams[0].pairs, ElementsAre(Pair(1, 3), Pair(2, 6)));
}

// Three panels that meet at a corner are one cluster with the lowest node as master; other nodes are alone.
TEST(Seam, ThreePanelsMeetInOneCluster) {
  Teuchos::ParameterList panels = two_panels(), seams;
  add_rectangle(panels, "sleeve", 30.0, 40.0, 3, 4);
  add_seam(seams, "side", "front.right", "back.left");
  add_seam(seams, "armhole", "back.left", "sleeve.bottom");
  const Clusters clusters = build(panels, seams).clusters;
  EXPECT_THAT(clusters.members[clusters.of_node[2]], ElementsAre(2, 12, 24));
  EXPECT_EQ(clusters.master(24), 2);
  EXPECT_THAT(clusters.members[clusters.of_node[0]], ElementsAre(0));
  EXPECT_EQ(clusters.members.size(), 24u + 20u - 8u);
  for (std::size_t node = 0; node < clusters.of_node.size(); ++node) {
    EXPECT_THAT(clusters.members[clusters.of_node[node]], ::testing::Contains(static_cast<int>(node)));
  }
}

// The prescribed separation starts at the placed distance, shrinks linearly and ends at zero.
TEST(Seam, SeparationClosesLinearly) {
  Teuchos::ParameterList panels = two_panels(), seams;
  panels.sublist("back").sublist("Placement").set("origin", test::reals({25.0, 0.0, 4.0}));
  add_seam(seams, "side", "front.right", "back.left");
  const Garment garment = build(panels, seams);
  EXPECT_NEAR((separation(garment.mesh, garment.clusters, 12, 0.0) - mesh::Vec3(5.0, 0.0, 4.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((separation(garment.mesh, garment.clusters, 12, 0.75) - mesh::Vec3(1.25, 0.0, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(separation(garment.mesh, garment.clusters, 12, 1.0), mesh::Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(separation(garment.mesh, garment.clusters, 2, 0.0), mesh::Vec3(0.0, 0.0, 0.0));
}

// Edges with different numbers of nodes cannot match: both are named with their nodes and lengths.
TEST(Seam, DifferentNodeCountsAreRefused) {
  Teuchos::ParameterList seams;
  add_seam(seams, "side", "front.right", "back.left");
  EXPECT_THAT(input_error([&seams] { build(two_panels(30.0, 5), seams); }),
              ::testing::AllOf(HasSubstr("a seam whose edges cannot match: \"front.right\" (4 nodes, 30 mm) and "
                                         "\"back.left\" (6 nodes, 30 mm) have different numbers of nodes"),
                               HasSubstr("scene.xml"), HasSubstr("side")));
}

// Edges with different lengths cannot match unless the seam's ease allows it.
TEST(Seam, DifferentLengthsNeedEase) {
  Teuchos::ParameterList seams;
  add_seam(seams, "side", "front.right", "back.left");
  EXPECT_THAT(
      input_error([&seams] { build(two_panels(33.0), seams); }),
      HasSubstr("a seam whose edges cannot match: the lengths of \"front.right\" (4 nodes, 30 mm) and \"back.left\" "
                "(4 nodes, 33 mm) differ by more than 5 % (parameter \"ease\")"));
  seams.sublist("side").set("ease", 0.1);
  EXPECT_EQ(build(two_panels(33.0), seams).seams[0].pairs.size(), 4u);
}

// Edges whose nodes are spaced differently cannot match node by node.
TEST(Seam, DifferentGradingIsRefused) {
  Teuchos::ParameterList panels = two_panels(), seams;
  panels.sublist("back").set("grading along", 2.0);
  add_seam(seams, "side", "front.right", "back.left");
  EXPECT_THAT(input_error([&] { build(panels, seams); }),
              HasSubstr("do not face each other (node 2 lies at 0.333333 and 0.222222 of the length)"));
}

// An edge that does not exist is refused with the nearest name and all names.
TEST(Seam, UnknownEdgeIsRefused) {
  Teuchos::ParameterList seams;
  add_seam(seams, "side", "front.rigth", "back.left");
  EXPECT_THAT(input_error([&seams] { build(two_panels(), seams); }),
              HasSubstr("there is no edge \"front.rigth\"; did you mean \"front.right\"? Valid here: back.bottom, "
                        "back.left, back.right, back.top, front.bottom, front.left, front.right, front.top"));
}

// A ring that goes all the way round is closed by one seam whose partners lie on each other from the start.
TEST(Seam, FullSectorClosesToARing) {
  Teuchos::ParameterList panels, seams;
  test::add_sector(panels, 360.0, 12, 4);
  add_seam(seams, "slit", "ring.left", "ring.right");
  const Garment garment = build(panels, seams);
  EXPECT_THAT(garment.seams[0].pairs, ElementsAre(Pair(0, 12), Pair(13, 25), Pair(26, 38), Pair(39, 51), Pair(52, 64)));
  for (const auto& [a, b] : garment.seams[0].pairs) {
    EXPECT_NEAR((garment.mesh.placed[a] - garment.mesh.placed[b]).norm(), 0.0, 1e-13);
  }
}

// Corners and other single nodes have names, but cannot be sewn.
TEST(Seam, SingleNodesAreRefused) {
  for (const char* name : {"front.top-left", "front.right@0.5", "front@0.5,0.5"}) {
    Teuchos::ParameterList seams;
    add_seam(seams, "side", name, "back.left");
    EXPECT_THAT(input_error([&seams] { build(two_panels(), seams); }),
                ::testing::AllOf(HasSubstr("a seam joins edges, and this is a single node"), HasSubstr(name),
                                 HasSubstr("Valid here: back.bottom, back.left, back.right")));
  }
}

// An edge cannot be sewn to itself.
TEST(Seam, EdgeWithItselfIsRefused) {
  Teuchos::ParameterList seams;
  add_seam(seams, "side", "front.right", "front.right");
  EXPECT_THAT(input_error([&seams] { build(two_panels(), seams); }),
              HasSubstr("the edge \"front.right\" cannot be sewn to itself"));
}

}  // namespace
}  // namespace toile::garment
