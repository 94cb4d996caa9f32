// Panels that are cut on a fold.
#include <gmock/gmock.h>

#include "panels.hpp"

namespace toile::pattern::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> names(const Loop& loop) {
  std::vector<std::string> all;
  for (const Edge& edge : loop) all.push_back(edge.name);
  return all;
}

// A square that is unfolded at its left edge is a rectangle of twice the width: the edges that meet the fold at a right
// angle go on, the other one has an image, the fold is a line, notches and holes are there twice.
TEST(Unfold, SquareBecomesRectangle) {
  Panel panel = square();
  panel.notches = {{"b", "bottom", 0.2}, {"r", "right", 0.3}};
  panel.holes = {round_hole({50.0, 40.0}, 10.0, "hole")};
  const Panel whole = unfolded(panel, "left");
  EXPECT_EQ(message([&] { check(whole); }), "no error");
  EXPECT_THAT(names(whole.outline), ElementsAre("bottom", "right", "top", "right.mirrored"));
  EXPECT_NEAR(whole.edge("bottom")->curve.length(), 200.0, 1e-12);
  EXPECT_EQ(whole.holes.size(), 2);
  ASSERT_EQ(whole.lines.size(), 1);
  EXPECT_EQ(whole.lines[0].name, "left");
  const auto place = [&](const std::string& name) {
    for (const Notch& notch : whole.notches)
      if (notch.name == name) return whole.edge(notch.edge)->curve.at(notch.at);
    return Vec2(1e9, 1e9);
  };
  EXPECT_NEAR((place("b") - Vec2(20.0, 0.0)).norm(), 0.0, 1e-10);
  EXPECT_NEAR((place("b.mirrored") - Vec2(-20.0, 0.0)).norm(), 0.0, 1e-10);
  EXPECT_NEAR((place("r") - Vec2(100.0, 30.0)).norm(), 0.0, 1e-10);
  EXPECT_NEAR((place("r.mirrored") - Vec2(-100.0, 30.0)).norm(), 0.0, 1e-10);
}

// An edge that meets the fold at another angle ends there, and its image is an edge of its own.
TEST(Unfold, ObliqueEdgeKeepsItsCorner) {
  Panel panel = square();
  panel.outline[1].curve = Curve::line({100.0, 0.0}, {100.0, 130.0});
  panel.outline[2].curve = Curve::line({100.0, 130.0}, {0.0, 100.0});
  const Panel whole = unfolded(panel, "left");
  EXPECT_EQ(message([&] { check(whole); }), "no error");
  EXPECT_THAT(names(whole.outline), ElementsAre("bottom", "right", "top", "top.mirrored", "right.mirrored"));
}

// A half disc of one arc and the fold becomes a disc whose one edge ends where it starts.
TEST(Unfold, HalfDiscBecomesDisc) {
  Panel panel;
  panel.name = "half";
  panel.outline = {{"fold", Curve::line({-50.0, 0.0}, {50.0, 0.0})},
                   {"rim", Curve::circular({0.0, 0.0}, 50.0, 0.0, M_PI)}};
  const Panel whole = unfolded(panel, "fold");
  EXPECT_EQ(message([&] { check(whole); }), "no error");
  ASSERT_THAT(names(whole.outline), ElementsAre("rim"));
  EXPECT_NEAR(whole.outline[0].curve.length(), 100.0 * M_PI, 1e-10);
}

// A fold that does not exist, is bent or has a notch is refused.
TEST(Unfold, WrongFoldsAreRefused) {
  Panel panel = square();
  EXPECT_THAT(message([&] { unfolded(panel, "lefd"); }),
              HasSubstr("panel \"square\" cannot be unfolded at \"lefd\": there is no edge of that name"));
  panel.notches = {{"n", "left", 0.5}};
  EXPECT_THAT(message([&] { unfolded(panel, "left"); }), HasSubstr("notch \"n\" lies on it"));
  panel.notches.clear();
  panel.outline[3].curve = Curve::quadratic({0.0, 100.0}, {-4.0, 50.0}, {0.0, 0.0});
  EXPECT_THAT(message([&] { unfolded(panel, "left"); }), HasSubstr("this edge is bent, by "));
}

}  // namespace
}  // namespace toile::pattern::test
