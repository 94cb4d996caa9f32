// Files of Garment-Pattern-Generator and GarmentCode.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "panels.hpp"
#include "scratch.hpp"
#include "toile/pattern/file.hpp"

namespace toile::pattern::test {
namespace {

using testing::HasSubstr;

const std::string folder = TOILE_SOURCE_DIR "/test/data/patterns/";

double length(const Pattern& pattern, const std::string& name) {
  const Side side = find_side(pattern, name);
  return side.part.edge->curve.length() * (side.part.to - side.part.from);
}

/// Centre of a panel's vertices in space.
Eigen::Vector3d centre(const Panel& panel) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Edge& edge : panel.outline) {
    const Vec2 p = edge.curve.front();
    sum += panel.placement->rotation * Eigen::Vector3d(p.x(), p.y(), 0.0) + panel.placement->translation;
  }
  return sum / static_cast<double>(panel.outline.size());
}

class RealPatterns : public testing::TestWithParam<const char*> {};

// Real patterns load: their loops close (which reading checks), and stitched edges agree in length within 0.35 %:
// the side seams of the shirt are 262.3 mm and 261.4 mm in its file.
TEST_P(RealPatterns, StitchedLengthsAgree) {
  const Pattern pattern = read_pattern(folder + GetParam());
  EXPECT_GT(pattern.stitches.size(), 3);
  for (const Stitch& stitch : pattern.stitches) {
    const double a = length(pattern, stitch.first), b = length(pattern, stitch.second);
    EXPECT_LT(std::abs(a - b) / a, 0.0035) << stitch.first << " " << stitch.second;
    EXPECT_TRUE(stitch.reversed);
  }
}

// Their right sides look away from the body: front panels to the front (z), back panels to the back.
TEST_P(RealPatterns, RightSidesLookOut) {
  for (const Panel& panel : read_pattern(folder + GetParam()).panels) {
    EXPECT_NEAR(panel.placement->rotation.determinant(), 1.0, 1e-12);
    EXPECT_GT(panel.placement->rotation(2, 2) * centre(panel).z(), 0.0) << panel.name;
  }
}

// Written and read again, outlines, placements and stitches are the same, also for programs that do not know our key.
TEST_P(RealPatterns, RoundTrip) {
  const Pattern pattern = read_pattern(folder + GetParam());
  const Scratch file(".json");
  write_pattern(pattern, file.path());
  const Pattern again = read_pattern(file.path());
  ASSERT_EQ(again.panels.size(), pattern.panels.size());
  for (const Panel& panel : pattern.panels)
    for (const Panel& other : again.panels)
      if (other.name == panel.name) {
        expect_same(panel, other, 1e-9);
        expect_same_placement(panel, other, 1e-9);
      }
  expect_same_stitches(pattern, again);
}

INSTANTIATE_TEST_SUITE_P(Json, RealPatterns,
                         testing::Values("gpg_tee.json", "gpg_tee_sleeveless.json",
                                         "garmentcode_shirt_mean_specification.json"));

// The front of the tee is placed as its file says, in mm: units_in_meter is 300.
TEST(Json, PlacementIsInMillimetres) {
  for (const Panel& panel : read_pattern(folder + "gpg_tee_sleeveless.json").panels) {
    if (panel.name != "front") continue;
    EXPECT_NEAR(panel.placement->translation.z(), 56.28 / 0.3, 1e-9);
    EXPECT_EQ(panel.outline.size(), 9);
  }
}

// A panel that is drawn clockwise is mirrored and stays where it is in space.
TEST(Json, BackPanelStaysInPlace) {
  std::ifstream in(folder + "gpg_tee_sleeveless.json");
  const auto json = nlohmann::json::parse(in);
  const auto& back = json["pattern"]["panels"]["back"];
  for (const Panel& panel : read_pattern(folder + "gpg_tee_sleeveless.json").panels) {
    if (panel.name != "back") continue;
    for (std::size_t k = 0; k < panel.outline.size(); ++k) {
      const auto& v = back["vertices"][back["edges"][k]["endpoints"][0].get<int>()];
      const Vec2 p = panel.outline[k].curve.front();
      const Eigen::Vector3d x =
          panel.placement->rotation * Eigen::Vector3d(p.x(), p.y(), 0.0) + panel.placement->translation;
      EXPECT_NEAR(x.x(), (v[0].get<double>() + 0.53) / 0.3, 1e-9);
      EXPECT_NEAR(x.y(), (v[1].get<double>() + 29.55) / 0.3, 1e-9);
      EXPECT_NEAR(x.z(), -46.53 / 0.3, 1e-9);
    }
  }
}

// Everything that a pattern can hold is the same after a round trip.
TEST(Json, EverythingRoundTrips) {
  const Pattern pattern = everything();
  const Scratch file(".json");
  write_pattern(pattern, file.path());
  const Pattern again = read_pattern(file.path());
  ASSERT_EQ(again.panels.size(), 2);
  for (const Panel& panel : again.panels) {
    const Panel& other = pattern.panels[panel.name == "front" ? 0 : 1];
    expect_same(other, panel, 1e-9);
    expect_same_placement(other, panel, 1e-9);
  }
  expect_same_stitches(pattern, again);
}

// Without our key, the pairs of the format join pieces of the same lengths in the same direction.
TEST(Json, PairsOfTheFormatAreRight) {
  Pattern pattern = everything();
  pattern.stitches[1].reversed = true;
  const Scratch file(".json");
  write_pattern(pattern, file.path());
  std::ifstream in(file.path());
  auto json = nlohmann::json::parse(in);
  json["pattern"].erase("toile");
  std::ofstream(file.path()) << json;
  const Pattern again = read_pattern(file.path());
  double seam = 0.0, partner = 0.0;
  for (const Stitch& stitch : again.stitches) {
    EXPECT_TRUE(stitch.reversed);
    if (find_side(again, stitch.first).part.edge->name != "right") continue;
    seam += length(again, stitch.first);
    partner += length(again, stitch.second);
    // The pattern's own map from one side to the other.
    const Side a = find_side(again, stitch.first), b = find_side(again, stitch.second);
    EXPECT_NEAR((a.part.from - 0.4) / 0.6, (1.0 - b.part.to) / 0.5, 1e-5);
    EXPECT_NEAR((a.part.to - 0.4) / 0.6, (1.0 - b.part.from) / 0.5, 1e-5);
  }
  EXPECT_NEAR(seam, length(pattern, pattern.stitches[0].first), 1e-3);
  EXPECT_NEAR(partner, length(pattern, pattern.stitches[0].second), 1e-3);
}

/// Message for a file of one triangle in which one text is replaced by another.
std::string refusal(const std::string& from, const std::string& to) {
  std::string text = R"({"pattern": {"panels": {"front": {"vertices": [[0, 0], [10, 0], [0, 10]], "edges": [
    {"endpoints": [0, 1]}, {"endpoints": [1, 2], "curvature": {"type": "circle", "params": [20, 0, 1]}},
    {"endpoints": [2, 0]}], "translation": [0, 0, 0], "rotation": [0, 0, 0]}},
    "stitches": [[{"panel": "front", "edge": 0}, {"panel": "front", "edge": 2}]]},
    "properties": {"units_in_meter": 100, "curvature_coords": "relative"}})";
  text.replace(text.find(from), from.size(), to);
  const Scratch file(".json", text);
  return message([&] { read_pattern(file.path()); });
}

// Errors name the file, the panel and the edge.
TEST(Json, ErrorsNameTheirPlace) {
  EXPECT_EQ(refusal("front", "front"), "no error");
  EXPECT_THAT(refusal("[1, 2]", "[1, 7]"),
              HasSubstr(".json: panel \"front\", edge 1, endpoints 1: expected a whole number from 0 to 2, found 7"));
  EXPECT_THAT(refusal("[20, 0, 1]", "[2, 0, 1]"),
              HasSubstr("panel \"front\", edge 1, curvature: a circular arc of radius 20 mm cannot join"));
  EXPECT_THAT(refusal("circle", "ellipse"), HasSubstr("\"ellipse\" is no type of curve"));
  EXPECT_THAT(refusal("[10, 0]", "[0, 0]"), HasSubstr("panel \"front\", edge 0: its two ends are the same point"));
  EXPECT_THAT(refusal("[2, 0]", "[2, 1]"), HasSubstr("panel \"front\": the outline is open"));
  EXPECT_THAT(refusal("\"edge\": 2", "\"edge\": 3"),
              HasSubstr("stitch 0, second side, edge: expected a whole number from 0 to 2"));
  EXPECT_THAT(refusal("\"units_in_meter\": 100, ", ""), HasSubstr("\"units_in_meter\" is missing"));
  EXPECT_THAT(refusal("relative", "relativ"), HasSubstr("neither \"relative\" nor \"absolute\""));
  EXPECT_THAT(refusal("{\"pattern\"", "{pattern"), HasSubstr("this is no valid JSON"));
}

// With normalize_panel_translation the panel turns about the mean of its vertices.
TEST(Json, NormalizedTranslation) {
  const Scratch file(".json", R"({"pattern": {"panels": {"p": {"vertices": [[0, 0], [30, 0], [0, 30]], "edges": [
    {"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}], "translation": [1, 2, 3],
    "rotation": [0, 0, 90]}}}, "properties": {"units_in_meter": 1000, "normalize_panel_translation": true}})");
  const Panel panel = read_pattern(file.path()).panels[0];
  const Eigen::Vector3d mean =
      panel.placement->rotation * Eigen::Vector3d(10.0, 10.0, 0.0) + panel.placement->translation;
  EXPECT_NEAR((mean - Eigen::Vector3d(11.0, 12.0, 3.0)).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace toile::pattern::test
