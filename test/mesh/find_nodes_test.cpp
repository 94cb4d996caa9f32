#include "toile/mesh/find_nodes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "toile/mesh/four_sided.hpp"

namespace toile::mesh {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Panels "back" and "front" of 4 x 6 elements; the nodes of "front" start at 35.
Mesh two_panels(double grading = 1.0) {
  Mesh mesh;
  GridOptions options;
  options.across = 4;
  options.along = 6;
  options.grading_along = grading;
  for (const char* name : {"back", "front"}) {
    const Grid grid = mesh_four_sided(name, rectangle(40.0, 60.0), options);
    const std::vector<Vec3> anywhere(grid.nodes.size(), Vec3::Zero());
    add_panel(mesh, name, panel_mesh(grid), {anywhere, anywhere}, {{"", {"knit", 0.0}}});
  }
  return mesh;
}

std::vector<int> nodes(const std::string& name, const Mesh& mesh = two_panels()) {
  const FoundNodes found = find_nodes(mesh, name);
  EXPECT_EQ(found.problem, "");
  return found.nodes;
}

std::string problem(const std::string& name) {
  const FoundNodes found = find_nodes(two_panels(), name);
  EXPECT_TRUE(found.nodes.empty());
  return found.problem;
}

// An edge gives its nodes in its order, a panel all of its nodes.
TEST(FindNodes, EdgesAndPanels) {
  EXPECT_THAT(nodes("front.bottom"), ElementsAre(35, 36, 37, 38, 39));
  const std::vector<int> all = nodes("front");
  ASSERT_EQ(all.size(), 35u);
  EXPECT_EQ(all.front(), 35);
  EXPECT_EQ(all.back(), 69);
}

// The four corners of a panel have names of their own.
TEST(FindNodes, Corners) {
  EXPECT_THAT(nodes("front.bottom-left"), ElementsAre(35));
  EXPECT_THAT(nodes("front.bottom-right"), ElementsAre(39));
  EXPECT_THAT(nodes("front.top-left"), ElementsAre(65));
  EXPECT_THAT(nodes("front.top-right"), ElementsAre(69));
}

// A place on an edge is the nearest node by arc length, whatever the grading; of two equally near ones the first.
TEST(FindNodes, PlaceOnEdge) {
  EXPECT_THAT(nodes("front.left@0"), ElementsAre(35));
  EXPECT_THAT(nodes("front.left@0.5"), ElementsAre(50));
  EXPECT_THAT(nodes("front.left@1"), ElementsAre(65));
  EXPECT_THAT(nodes("front.bottom@0.6"), ElementsAre(37));
  EXPECT_THAT(nodes("front.bottom@0.375"), ElementsAre(36));
  EXPECT_THAT(nodes("front.left@0.17"), ElementsAre(40));
  EXPECT_THAT(nodes("front.left@0.17", two_panels(2.0)), ElementsAre(45));
}

// A place in a panel is the node where the nearest column and the nearest row cross.
TEST(FindNodes, PlaceInPanel) {
  EXPECT_THAT(nodes("front@0.5,0.5"), ElementsAre(35 + 3 * 5 + 2));
  EXPECT_THAT(nodes("front@1,0"), ElementsAre(39));
  EXPECT_THAT(nodes("back@0.25,1"), ElementsAre(31));
}

// A name that means nothing is answered with the nearest one, all edges and panels, and the forms of single nodes.
TEST(FindNodes, UnknownNames) {
  EXPECT_THAT(problem("front.botom"),
              StartsWith("no edge or panel is named \"front.botom\"; did you mean \"front.bottom\"? Valid here: back, "
                         "front, back.bottom, back.left, back.right, back.top, front.bottom, front.left, front.right, "
                         "front.top; the corners of a panel, <panel>.bottom-left, "));
  EXPECT_THAT(problem("front.top-rigth"), HasSubstr("did you mean \"front.top-right\"?"));
  EXPECT_THAT(problem("front.side@0.5"), HasSubstr("no edge or panel is named \"front.side\""));
  EXPECT_THAT(problem("sleeve.top-right"), HasSubstr("no edge or panel is named \"sleeve.top-right\""));
}

// A place on an edge is one number from 0 to 1, a place in a panel two, and a corner has none.
TEST(FindNodes, BadPlaces) {
  for (const char* name : {"front.left@1.5", "front.left@-0.1", "front.left@half", "front.left@", "front.left@0.5,0.5",
                           "front.left@0.5 "}) {
    EXPECT_EQ(problem(name), "\"" + std::string(name) +
                                 "\" must have one number from 0 to 1 after the @, the relative length along the edge");
  }
  EXPECT_THAT(problem("front@0.5"), HasSubstr("\"front@0.5\" must have two numbers from 0 to 1 after the @"));
  EXPECT_EQ(problem("front.top-left@0.5"), "\"front.top-left\" is one node, so \"@\" and a place cannot follow");
}

// A part of an edge is the nodes between its bounds: relative arc lengths, lengths in mm, or notches.
TEST(FindNodes, PartOfAnEdge) {
  Mesh mesh = two_panels();
  const std::vector<int> left = mesh.edges.at("front.left");
  const auto part = [&left](std::size_t from, std::size_t to) {
    return std::vector<int>(left.begin() + static_cast<std::ptrdiff_t>(from),
                            left.begin() + static_cast<std::ptrdiff_t>(to) + 1);
  };
  const std::size_t last = left.size() - 1;
  ASSERT_GE(last, 3U);
  EXPECT_EQ(find_nodes(mesh, "front.left[start:end]").nodes, left);
  const double third = 60.0 / static_cast<double>(last);
  EXPECT_EQ(find_nodes(mesh, "front.left[start:" + std::to_string(third) + "mm]").nodes, part(0, 1));
  mesh.panels.back().notches = {{"mark", "left", left[2]}};
  EXPECT_EQ(find_nodes(mesh, "front.left[mark:end]").nodes, part(2, last));
  EXPECT_THAT(find_nodes(mesh, "front.left[marc:end]").problem, HasSubstr("mark"));
  EXPECT_THAT(find_nodes(mesh, "front.left[0.5:0.5]").problem, ::testing::Not(""));
  EXPECT_THAT(find_nodes(mesh, "frnt.left[0:0.5]").problem, HasSubstr("front.left"));
}

// A panel that was not meshed row by row has no places inside.
TEST(FindNodes, PanelWithoutRows) {
  Mesh mesh = two_panels();
  mesh.panels.back().across = 0;
  EXPECT_EQ(find_nodes(mesh, "front@0.5,0.5").problem,
            "panel \"front\" has no rows and columns of elements; a point of its pattern is \"front@(12.5,40)\"");
}

/// Sum of the lengths, and of the lengths times the arc lengths of their nodes.
std::pair<double, double> moments(const std::string& name, const Mesh& mesh) {
  const EdgeLengths edge = edge_lengths(mesh, name);
  const std::vector<double> arc = arc_lengths(mesh, edge.nodes);
  double length = 0.0, moment = 0.0;
  for (std::size_t k = 0; k < arc.size(); ++k) {
    length += edge.lengths[k];
    moment += edge.lengths[k] * arc[k];
  }
  return {length, moment};
}

// What lies on a part of an edge has the part's length and its middle, also where it ends between nodes or lies within
// one element.
TEST(EdgeLengths, OfAPartThatEndsBetweenNodes) {
  for (const double grading : {1.0, 4.0}) {
    const Mesh mesh = two_panels(grading);
    for (const auto& [from, to] : {std::pair(13.0, 47.0), {0.0, 59.0}, {21.0, 22.5}, {50.0, 59.9}}) {
      const std::string name = "front.left[" + std::to_string(from) + "mm:" + std::to_string(to) + "mm]";
      const auto [length, moment] = moments(name, mesh);
      EXPECT_NEAR(length, to - from, 1e-9) << name;
      EXPECT_NEAR(moment, 0.5 * (to * to - from * from), 1e-9) << name;
    }
    EXPECT_NEAR(moments("front.left", mesh).first, 60.0, 1e-9);
  }
}

// A place on an edge is by arc length, whatever the grading, and between nodes if it must.
TEST(EdgePlaces, AreByArcLength) {
  for (const double grading : {1.0, 4.0}) {
    const Mesh mesh = two_panels(grading);
    for (const double at : {0.0, 0.13, 0.5, 0.57, 1.0}) {
      const EdgePlace place = edge_place(mesh, mesh.edges.at("front.left"), at);
      const Vec2 there = (1.0 - place.share) * mesh.pattern[place.first] + place.share * mesh.pattern[place.second];
      EXPECT_NEAR(there.y(), 60.0 * at, 1e-9);
      EXPECT_GE(place.share, 0.0);
      EXPECT_LE(place.share, 1.0);
    }
  }
}

// How far the end of a part lies from its node is told.
TEST(FindNodes, TellsWherePartsEndBetweenNodes) {
  EXPECT_NEAR(find_nodes(two_panels(), "front.left[13mm:48mm]").off, 3.0, 1e-9);
  EXPECT_NEAR(find_nodes(two_panels(), "front.left[10mm:50mm]").off, 0.0, 1e-9);
}

}  // namespace
}  // namespace toile::mesh
