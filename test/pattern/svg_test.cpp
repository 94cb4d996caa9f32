// Drawings in SVG.
#include "toile/pattern/svg.hpp"

#include <gmock/gmock.h>

#include "panels.hpp"
#include "scratch.hpp"
#include "toile/pattern/file.hpp"

namespace toile::pattern::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A drawing of 200 mm by 100 mm with 400 by 200 units.
std::string drawing(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20cm\" height=\"100mm\" viewBox=\"0 0 400 200\">" +
         content + "</svg>";
}

Pattern read(const std::string& text) {
  const Scratch file(".svg", text);
  return read_pattern(file.path());
}

double outline_length(const Panel& panel) {
  double sum = 0.0;
  for (const Edge& edge : panel.outline) sum += edge.curve.length();
  return sum;
}

// Everything that a pattern can hold is the same after a round trip.
TEST(Svg, EverythingRoundTrips) {
  const Pattern pattern = everything();
  const Scratch file(".svg");
  write_pattern(pattern, file.path());
  const Pattern again = read_pattern(file.path());
  ASSERT_EQ(again.panels.size(), 2);
  for (std::size_t k = 0; k < 2; ++k) {
    expect_same(pattern.panels[k], again.panels[k], 2e-6);
    expect_same_placement(pattern.panels[k], again.panels[k], 1e-9);
  }
  expect_same_stitches(pattern, again);
}

// All commands, absolute and relative, draw the same outline; units and viewBox make it mm, and y points up.
TEST(Svg, PathsOfAllCommands) {
  const char* const paths[] = {
      "M 20 20 L 120 20 H 200 V 60 C 200 100 160 120 120 120 S 60 140 40 120 Q 10 100 20 80 T 20 40 Z",
      "m20,20 100,0h80v40c0,40-40,60-80,60s-60,20-80,0q-30-20-20-40t0-40z",
      "M20 20 120 20 200 20 200 60C200 100 160 120 120 120 80 120 60 140 40 120Q10 100 20 80 30 60 20 40z"};
  std::vector<Panel> panels;
  for (const char* path : paths)
    panels.push_back(read(drawing(std::string("<path id='p' d='") + path + "'/>")).panels[0]);
  for (const Panel& panel : panels) {
    EXPECT_EQ(panel.name, "p");
    EXPECT_NEAR(outline_length(panel), outline_length(panels[0]), 1e-9);
  }
  EXPECT_NEAR((panels[0].outline.back().curve.back() - panels[0].outline.front().curve.front()).norm(), 0.0, 1e-9);
  double top = -1e9;
  for (const Edge& edge : panels[0].outline) top = std::max(top, edge.curve.front().y());
  EXPECT_NEAR(top, -10.0, 1e-9);
}

// Arcs with compact flags, of circles and ellipses, have the lengths of theirs; a radius that is too small grows.
TEST(Svg, Arcs) {
  const auto length = [](const std::string& d) {
    return outline_length(read(drawing("<path d='" + d + "'/>")).panels[0]);
  };
  EXPECT_NEAR(length("M100 100a40 40 0 01 40 40h-40z"), 0.5 * (40.0 * M_PI / 2 + 80.0), 1e-9);
  EXPECT_NEAR(length("M100 100A40,40,0,1,1,140 140L100 140z"), 0.5 * (40.0 * 1.5 * M_PI + 80.0), 1e-9);
  EXPECT_NEAR(length("M100 100a1 1 0 0 1 80 0z"), 0.5 * (40.0 * M_PI + 80.0), 1e-9);
  // Ellipse of half axes 60 and 30, by its complete elliptic integral (Ramanujan's series is exact to 1e-9 here).
  const double h = std::pow(30.0 / 90.0, 2);
  const double ellipse = M_PI * 90.0 * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
  EXPECT_NEAR(length("M40 100a60 30 0 1 1 120 0a60 30 0 1 1 -120 0z"), 0.5 * ellipse, 2e-4);
  EXPECT_NEAR(length("M100 40a60 30 90 1 1 0 120a60 30 90 1 1 0 -120z"), 0.5 * ellipse, 2e-4);
}

// Transforms of the element and of groups around it apply from the inside out.
TEST(Svg, Transforms) {
  const Panel panel = read(drawing("<g transform='translate(50 20)'><g transform='rotate(90) scale(2)'>"
                                   "<rect id='r' width='20' height='10'/></g></g>"))
                          .panels[0];
  Vec2 low(1e9, 1e9), high(-1e9, -1e9);
  for (const Edge& edge : panel.outline) {
    low = low.cwiseMin(edge.curve.front());
    high = high.cwiseMax(edge.curve.front());
  }
  EXPECT_NEAR((low - Vec2(15.0, -30.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((high - Vec2(25.0, -10.0)).norm(), 0.0, 1e-9);
  const Panel circle = read(drawing("<circle r='20' transform='matrix(0 1 1 0 50 50) scale(1.5)'/>")).panels[0];
  EXPECT_NEAR(outline_length(circle), 30.0 * M_PI, 1e-9);
}

// Shapes of other kinds are outlines; loops of one path are holes; open lines lie on panels; ids are names.
TEST(Svg, ShapesAreOutlines) {
  const Pattern pattern = read(drawing(
      "<polygon id='kite' points='10,10 50,10 50,50 10,60'/><rect id='round' x='60' y='10' width='40' height='30' "
      "rx='5'/>"
      "<path id='holed' d='M110 10h60v60h-60z M120 20h20v20h-20z'/><ellipse id='egg' cx='250' cy='50' rx='30' ry='20'/>"
      "<polyline id='dart' points='20,20 30,40 40,20'/><path id='unseen' style='display: none' d='nonsense'/>"));
  ASSERT_EQ(pattern.panels.size(), 4);
  EXPECT_EQ(pattern.panels[0].name, "kite");
  EXPECT_EQ(pattern.panels[0].outline.size(), 4);
  EXPECT_EQ(pattern.panels[0].lines.at(0).name, "dart");
  EXPECT_NEAR(outline_length(pattern.panels[1]), 0.5 * (60.0 + 40.0 + 10.0 * M_PI), 1e-6);
  EXPECT_EQ(pattern.panels[1].outline.size(), 1) << "it has no corners";
  EXPECT_EQ(pattern.panels[2].holes.size(), 1);
  EXPECT_EQ(pattern.panels[3].name, "egg");
}

// Pixels of CSS where there is neither unit nor viewBox.
TEST(Svg, PixelsWithoutUnits) {
  const Panel panel = read("<svg><rect width='96' height='96'/></svg>").panels[0];
  EXPECT_NEAR(outline_length(panel), 4.0 * 25.4, 1e-9);
}

// What cannot be read is refused with file, element and place.
TEST(Svg, ErrorsNameTheirPlace) {
  const auto refusal = [](const std::string& text) { return message([&] { read(text); }); };
  EXPECT_THAT(refusal(drawing("<path id='p' d='M 0 0 L 10 X'/>")),
              HasSubstr(".svg: <path> \"p\": path \"M 0 0 L 10 X\": not understood at character "));
  EXPECT_THAT(refusal(drawing("<path id='p' d='L 10 10'/>")), HasSubstr("at character 1"));
  EXPECT_THAT(refusal(drawing("<path id='p' d='M0 0 L 1e9 0 L 0 5 Z'/>")), HasSubstr("too large for a garment"));
  EXPECT_THAT(refusal(drawing("<rect id='r' width='10' height='0'/>")), HasSubstr("height must be given and positive"));
  EXPECT_THAT(refusal(drawing("<g transform='turn(3)'/>")), HasSubstr("\"turn\" with 1 numbers is none of"));
  for (const std::string css : {"transform:scale(2)", "fill:none; transform : scale(2)", "scale:2"})
    EXPECT_THAT(refusal(drawing("<rect id='r' width='10' height='10' style='" + css + "'/>")),
                AllOf(HasSubstr(".svg: <rect> \"r\": its attribute \"style\" has \""),
                      HasSubstr("write it as the attribute \"transform\"")));
  EXPECT_THAT(refusal(drawing("<use href='#a'/>")), HasSubstr("unlink them first"));
  EXPECT_THAT(refusal(drawing("<path id='open' d='M500 0 h 5'/>")),
              HasSubstr("the open line \"open\" lies on no panel"));
  EXPECT_THAT(refusal(drawing("")), HasSubstr("there is no panel in this file"));
  EXPECT_THAT(refusal("<svg viewBox='0 0 10 10'/>"), HasSubstr("no size on paper"));
  EXPECT_THAT(refusal("<svg width='100%' height='10mm' viewBox='0 0 10 10'/>"),
              HasSubstr("\"100%\" is no length on paper"));
  EXPECT_THAT(refusal("<html/>"), HasSubstr("its first element is <html>"));
  EXPECT_THAT(refusal("<svg>"), HasSubstr("no valid XML"));
}

// The drawing is in true scale: its size is in mm and equals its user units.
TEST(Svg, DrawingIsInTrueScale) {
  const Scratch file(".svg");
  write_svg({{square()}, {}}, file.path(), {true});
  EXPECT_THAT(file.content(), HasSubstr("width=\"140mm\" height=\"140mm\" viewBox=\"0 0 140 140\""));
}

// Pages tile the drawing: a panel of 500 mm by 300 mm takes three by two pages of A4.
TEST(Svg, PagesTileTheDrawing) {
  Panel panel = square();
  panel.outline = {{"all", Curve::polyline({{0.0, 0.0}, {500.0, 0.0}, {500.0, 300.0}, {0.0, 300.0}, {0.0, 0.0}})}};
  const Scratch file("");
  const std::vector<std::string> pages = write_svg_pages({{panel}, {}}, file.path());
  EXPECT_EQ(pages.size(), 6);
  for (const std::string& page : pages) EXPECT_EQ(std::remove(page.c_str()), 0);
  EXPECT_EQ(pages.back(), file.path() + "-2-3.svg");
}

}  // namespace
}  // namespace toile::pattern::test
