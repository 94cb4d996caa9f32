#include "toile/pattern/area.hpp"

#include <gmock/gmock.h>

#include "panels.hpp"
#include "toile/pattern/lines.hpp"

namespace toile::pattern {
namespace {

using ::testing::HasSubstr;

/// A square whose right side is an arc that bulges by 20 mm.
Panel bulged() {
  Panel panel = test::square();
  panel.outline[1].curve = Curve::circular({100.0, 0.0}, {100.0, 100.0}, 72.5, false, true);
  return panel;
}

// A band ends on the edges themselves, closer than any point that stands for them, so that a seam finds the end on the
// other edge at the same place; what lies along an edge is no border.
TEST(Area, BandEndsOnTheEdges) {
  Panel panel = bulged();
  const std::vector<InternalLine> lines =
      borders(panel, {band(panel, "hem", -5.0, 30.0), band(panel, "b", 60.0, 100.0)});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].name, "hem border");
  const double heights[] = {30.0, 60.0};
  for (const std::size_t k : {0u, 1u}) {
    Vec2 right = lines[k].curve.front(), left = lines[k].curve.back();
    if (right.x() < left.x()) std::swap(left, right);
    EXPECT_NEAR((left - Vec2(0.0, heights[k])).norm(), 0.0, 1e-9);
    EXPECT_NEAR(right.y(), heights[k], 1e-9);
    EXPECT_NEAR((right - Vec2(100.0 + 20.0 - 72.5, 50.0)).norm(), 72.5, 1e-3);  // on the arc
  }
  panel.lines = lines;
  EXPECT_NO_THROW(check_lines(panel));
}

// Sides that zones share are there once; an area inside of the panel has a closed border, in two parts; a hole cuts it.
TEST(Area, SharedSidesAndClosedBorders) {
  Panel panel = test::square();
  EXPECT_EQ(borders(panel, {band(panel, "low", 20.0, 40.0), band(panel, "high", 40.0, 60.0)}).size(), 3u);
  const Area inside{"patch", {{20.0, 20.0}, {20.0, 60.0}, {50.0, 60.0}, {50.0, 20.0}}};
  double length = 0.0;
  for (const InternalLine& line : borders(panel, {inside})) length += line.curve.length();
  EXPECT_NEAR(length, 140.0, 1e-9);
  panel.holes = {test::round_hole({50.0, 40.0}, 8.0, "hole")};
  panel.lines = borders(panel, {inside});
  length = 0.0;
  for (const InternalLine& line : panel.lines) length += line.curve.length();
  EXPECT_NEAR(length, 124.0, 2e-2);
  EXPECT_NO_THROW(check_lines(panel));
}

// What cannot be is refused with the zone and the place.
TEST(Area, RefusesWhatHoldsNoFabric) {
  const Panel panel = test::square();
  const auto message = [&](const std::vector<Area>& areas) { return test::message([&] { borders(panel, areas); }); };
  EXPECT_THAT(message({band(panel, "far", 120.0, 140.0)}), HasSubstr("zone \"far\""));
  EXPECT_THAT(message({band(panel, "far", 120.0, 140.0)}), HasSubstr("y from 0 to 100 mm"));
  EXPECT_THAT(message({band(panel, "a", 20.0, 50.0), band(panel, "b", 40.0, 60.0)}),
              HasSubstr("\"a\" and \"b\" overlap (x from 0 to 100, y from 40 to 50 mm)"));
  EXPECT_THAT(message({{"bow", {{10.0, 10.0}, {50.0, 50.0}, {50.0, 10.0}, {10.0, 50.0}}}}),
              HasSubstr("crosses itself"));
  EXPECT_THAT(message({{"line", {{10.0, 10.0}, {50.0, 50.0}}}}), HasSubstr("encloses no area"));
}

}  // namespace
}  // namespace toile::pattern
