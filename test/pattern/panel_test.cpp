// What makes a panel a piece of fabric.
#include "toile/pattern/panel.hpp"

#include <gmock/gmock.h>

#include "panels.hpp"

namespace toile::pattern::test {
namespace {

using testing::HasSubstr;

std::string refusal(const Panel& panel) {
  return message([&] { check(panel); });
}

// A panel with a hole is accepted.
TEST(Panel, PieceWithHoleIsValid) {
  Panel panel = square();
  panel.holes = {round_hole({50.0, 50.0}, 20.0, "hole")};
  EXPECT_EQ(refusal(panel), "no error");
}

// An open outline is told with both edges and points.
TEST(Panel, OpenOutlineIsRefused) {
  Panel panel = square();
  panel.outline[1].curve = Curve::line({100.0, 0.0}, {100.0, 99.0});
  EXPECT_EQ(refusal(panel),
            "panel \"square\": the outline is open: edge \"right\" ends at (100, 99) mm, and edge \"top\" starts at "
            "(100, 100) mm; they must be the same point");
}

// An outline that crosses itself is told with the place.
TEST(Panel, CrossingOutlineIsRefused) {
  Panel panel = square();
  const auto cross = [&panel](double height) {
    panel.outline[1].curve = Curve::line({100.0, 0.0}, {0.0, height});
    panel.outline[2].curve = Curve::line({0.0, height}, {100.0, height});
    panel.outline[3].curve = Curve::line({100.0, height}, {0.0, 0.0});
    orient(panel);
    return refusal(panel);
  };
  EXPECT_THAT(cross(100.0), HasSubstr("it overlaps itself"));
  panel.outline[0].curve = Curve::polyline({{0.0, 0.0}, {50.0, -10.0}, {100.0, 0.0}});
  EXPECT_THAT(cross(100.0), HasSubstr("it overlaps itself near (50, 50) mm of its pattern"));
}

// A hole that touches the outline in one point, or overlaps another hole, is refused.
TEST(Panel, TouchingHolesAreRefused) {
  Panel panel = square();
  panel.holes = {{{"hole", Curve::polyline({{50.0, 0.0}, {40.0, 20.0}, {60.0, 20.0}, {50.0, 0.0}})}}};
  EXPECT_THAT(refusal(panel), HasSubstr("the hole with edge \"hole\" touches or crosses the outline"));
  panel.holes = {round_hole({40.0, 50.0}, 20.0, "one"), round_hole({60.0, 50.0}, 20.0, "two")};
  EXPECT_THAT(refusal(panel), HasSubstr("the hole with edge \"two\" touches or crosses the hole with edge \"one\""));
}

// A hole that runs the wrong way is told as such, in an outline of arcs too.
TEST(Panel, HoleTheWrongWayRoundIsRefused) {
  const auto arcs = [](double radius, const std::string& name) {
    const Vec2 right(radius, 0.0), left(-radius, 0.0);
    return Loop{{name + " back", Curve::circular(right, left, radius, false, true)},
                {name + " front", Curve::circular(left, right, radius, false, true)}};
  };
  Panel panel = square();
  panel.outline = arcs(150.0, "rim");
  EXPECT_EQ(refusal(panel), "no error");
  panel.holes = {arcs(90.0, "hole")};
  EXPECT_THAT(refusal(panel), HasSubstr("the outline must run counter-clockwise and holes clockwise"));
  orient(panel);
  EXPECT_EQ(refusal(panel), "no error");
}

// A hole outside of the outline is refused.
TEST(Panel, HoleOutsideIsRefused) {
  Panel panel = square();
  panel.holes = {round_hole({150.0, 50.0}, 20.0, "hole")};
  EXPECT_THAT(refusal(panel), HasSubstr("a hole lies outside of the outline"));
}

// Equal names, missing names, edges without length and notches on no edge are refused.
TEST(Panel, NamesAndNotchesAreChecked) {
  Panel panel = square();
  panel.outline[2].name = "left";
  EXPECT_THAT(refusal(panel), HasSubstr("the name \"left\" is given twice"));
  panel.outline[2].name = "";
  EXPECT_THAT(refusal(panel), HasSubstr("there is an edge without a name"));
  panel = square();
  panel.notches = {{"n", "botom", 0.5}};
  EXPECT_THAT(refusal(panel), HasSubstr("notch \"n\" lies on edge \"botom\", which does not exist"));
  EXPECT_THAT(refusal(panel), HasSubstr("\"bottom\""));
  panel.notches = {{"n", "bottom", 1.5}};
  EXPECT_THAT(refusal(panel), HasSubstr("allowed are 0 to 1"));
  panel = square();
  panel.outline.insert(panel.outline.begin(), {"nothing", Curve::line({0.0, 0.0}, {0.0, 0.0})});
  EXPECT_THAT(refusal(panel), HasSubstr("edge \"nothing\" near (0, 0) mm has no length"));
}

// Orienting turns outline and holes, and notches keep their places.
TEST(Panel, OrientTurnsLoops) {
  const Panel panel = square();
  Panel turned = panel;
  turned.outline.clear();
  for (auto edge = panel.outline.rbegin(); edge != panel.outline.rend(); ++edge)
    turned.outline.push_back({edge->name, edge->curve.reversed()});
  turned.notches = {{"n", "bottom", 0.25}};
  turned.holes = {{{"hole", Curve::circular({50.0, 50.0}, 20.0, 0.0, 2.0 * M_PI)}}};
  EXPECT_THAT(refusal(turned), HasSubstr("the outline must run counter-clockwise"));
  orient(turned);
  EXPECT_EQ(refusal(turned), "no error");
  EXPECT_NEAR((turned.edge("bottom")->curve.at(turned.notches[0].at) - Vec2(75.0, 0.0)).norm(), 0.0, 1e-12);
}

// Panels and stitches of a pattern need names of their own, and stitches edges that exist.
TEST(Pattern, StitchesAreChecked) {
  Pattern pattern = everything();
  EXPECT_EQ(message([&] { check(pattern); }), "no error");
  pattern.stitches[1].first = "front.tob";
  EXPECT_THAT(message([&] { check(pattern); }), HasSubstr("stitch \"shoulder\": panel \"front\" has no edge \"tob\""));
  pattern = everything();
  pattern.stitches[1].name = "side seam";
  EXPECT_THAT(message([&] { check(pattern); }), HasSubstr("there are two stitches \"side seam\""));
  pattern = everything();
  pattern.panels[1].name = "front";
  EXPECT_THAT(message([&] { check(pattern); }), HasSubstr("there are two panels \"front\""));
}

}  // namespace
}  // namespace toile::pattern::test
