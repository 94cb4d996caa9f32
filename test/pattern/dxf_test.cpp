// Pieces in DXF, in the layers of ASTM D6673.
#include <gmock/gmock.h>

#include "panels.hpp"
#include "scratch.hpp"
#include "toile/pattern/file.hpp"

namespace toile::pattern::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A polyline of DXF; bulges follow the points of two numbers.
std::string polyline(const std::string& layer, const std::vector<std::array<double, 3>>& vertices) {
  std::string text = "0\nPOLYLINE\n8\n" + layer + "\n66\n1\n70\n1\n";
  for (const auto& [x, y, bulge] : vertices)
    text += "0\nVERTEX\n8\n" + layer + "\n10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n42\n" +
            std::to_string(bulge) + "\n";
  return text + "0\nSEQEND\n8\n" + layer + "\n";
}

std::string text(const std::string& words) {
  return "0\nTEXT\n8\n1\n10\n0\n20\n0\n40\n3\n1\n" + words + "\n";
}

std::string point(const std::string& layer, double x, double y) {
  return "0\nPOINT\n8\n" + layer + "\n10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n";
}

/// A file of one piece.
std::string file_of(const std::string& piece, const std::string& units = text("Units: METRIC")) {
  return "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n1\n2\nP1\n70\n0\n10\n0\n20\n0\n" + text("Piece Name: front") + piece +
         "0\nENDBLK\n8\n1\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + units + "0\nENDSEC\n0\nEOF\n";
}

const std::vector<std::array<double, 3>> quad{{0, 0, 0}, {100, 0, 0}, {100, 50, 0}, {0, 50, 0}};

/// The same of a square, with $INSUNITS; `word`: of the text, empty: without.
std::string with_variable(const std::string& variable, const std::string& word) {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + variable + "\n0\nENDSEC\n" +
         file_of(polyline("1", quad), word.empty() ? "" : text("Units: " + word));
}

Panel read(const std::string& content) {
  const Scratch file(".dxf", content);
  return read_pattern(file.path()).panels.at(0);
}

// Everything that the format can hold is the same after a round trip, within 0.002 mm.
TEST(Dxf, EverythingRoundTrips) {
  const Pattern pattern = everything();
  const Scratch file(".dxf");
  write_pattern(pattern, file.path());
  const Pattern again = read_pattern(file.path());
  ASSERT_EQ(again.panels.size(), 2);
  for (std::size_t k = 0; k < 2; ++k) expect_same(pattern.panels[k], again.panels[k], 0.002);
}

// A piece of another program: edges end at its turn points, and smooth runs are splines through its curve points.
TEST(Dxf, TurnPointsEndEdges) {
  std::vector<std::array<double, 3>> vertices{{0, 0, 0}};
  std::string points = point("2", 0, 0) + point("2", 100, 0);
  for (int k = 0; k <= 8; ++k) {
    const double angle = M_PI * k / 8;
    vertices.push_back({50 + 50 * std::cos(angle), 50 * std::sin(angle), 0});
    if (k > 0 && k < 8) points += point("3", vertices.back()[0], vertices.back()[1]);
  }
  const Panel panel = read(file_of(polyline("1", vertices) + points + point("4", 50, 50)));
  EXPECT_EQ(panel.name, "front");
  ASSERT_EQ(panel.outline.size(), 2);
  EXPECT_NEAR(panel.outline[1].curve.length(), 50.0 * M_PI, 0.3);
  ASSERT_EQ(panel.notches.size(), 1);
  EXPECT_EQ(panel.notches[0].edge, panel.outline[1].name);
  EXPECT_NEAR(panel.notches[0].at, 0.5, 1e-6);
}

// Without turn points, edges end at corners; bulges are arcs; inches are 25.4 mm; the sew line goes before the
// boundary.
TEST(Dxf, CornersBulgesUnitsSewLines) {
  EXPECT_EQ(read(file_of(polyline("1", quad))).outline.size(), 4);
  const Panel inches = read(file_of(polyline("1", quad), text("UNITS: ENGLISH")));
  EXPECT_NEAR(inches.outline[0].curve.length(), 2540.0, 1e-9);
  const Panel disc = read(file_of(polyline("1", {{0, 0, 1}, {100, 0, 1}})));
  double length = 0.0;
  for (const Edge& edge : disc.outline) length += edge.curve.length();
  EXPECT_NEAR(length, 100.0 * M_PI, 1e-9);
  const Panel sewn =
      read(file_of(polyline("1", quad) + polyline("14", {{10, 10, 0}, {90, 10, 0}, {90, 40, 0}, {10, 40, 0}})));
  EXPECT_NEAR(sewn.outline[0].curve.length(), 80.0, 1e-9);
}

// The unit is told by the text of the standard, by the variable of others, or by both.
TEST(Dxf, TextAndVariableTellTheUnit) {
  for (const auto& [variable, word] : {std::pair("1", "ENGLISH"), std::pair("1", ""), std::pair("0", "ENGLISH")})
    EXPECT_NEAR(read(with_variable(variable, word)).outline[0].curve.length(), 2540.0, 1e-9) << variable << word;
}

// What cannot be read is refused with file and piece.
TEST(Dxf, ErrorsNameTheirPlace) {
  const auto refusal = [](const std::string& content) { return message([&] { read(content); }); };
  EXPECT_THAT(refusal(file_of(polyline("1", quad), "")), HasSubstr(".dxf: the file does not tell its unit"));
  EXPECT_THAT(refusal(with_variable("1", "METRIC")),
              AllOf(HasSubstr(".dxf: the file contradicts itself"), HasSubstr("$INSUNITS = 1 says 25.4 mm"),
                    HasSubstr("\"UNITS: METRIC\" says 1 mm")));
  EXPECT_THAT(refusal(file_of(polyline("9", quad))),
              HasSubstr("piece \"front\": there is no closed polyline on layer 1"));
  EXPECT_THAT(refusal(file_of(polyline("1", quad) + polyline("1", quad))),
              HasSubstr("layer 1 has two closed polylines"));
  EXPECT_THAT(refusal("AutoCAD Binary DXF"), HasSubstr("line 1: expected the code of a group"));
  const std::string whole = file_of(polyline("1", quad));
  EXPECT_THAT(refusal(whole.substr(0, whole.size() / 2)), HasSubstr("cut off"));
  EXPECT_THAT(refusal(file_of("0\nCIRCLE\n8\n1\n10\n0\n20\n0\n40\n5\n")),
              HasSubstr("has the entity CIRCLE on layer 1"));
}

}  // namespace
}  // namespace toile::pattern::test
