#include "toile/garment/pattern.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "lists.hpp"
#include "toile/garment/garment.hpp"
#include "toile/garment/panel.hpp"
#include "toile/garment/seam.hpp"
#include "toile/pattern/file.hpp"

namespace toile::garment::test {
namespace {

using mesh::Vec3;
using ::testing::HasSubstr;

const std::string folder = TOILE_SOURCE_DIR "/test/data/patterns/";

/// A scene with a list "Pattern" of one of the files.
Teuchos::ParameterList scene_of(const std::string& file, double size) {
  Teuchos::ParameterList scene("scene");
  Teuchos::ParameterList& pattern = scene.sublist("Pattern");
  pattern.set("file", file);
  pattern.set("material", std::string("knit"));
  pattern.set("element size", size);
  return scene;
}

base::List read(const Teuchos::ParameterList& scene) {
  base::Spec spec("scene", "");
  spec.list(pattern_spec()).list(panels_spec(), true).list(seams_spec()).completed_by(add_pattern);
  return base::validate(scene, spec, folder + "scene.xml");
}

Garment build(const Teuchos::ParameterList& scene) {
  const base::List list = read(scene);
  const base::List seams = list.list("Seams");
  return build_garment(list.list("Panels"), &seams, nullptr);
}

double length_of(const mesh::Mesh& mesh, const std::vector<int>& nodes) {
  return mesh::arc_lengths(mesh, nodes).back();
}

struct File {
  const char* name;
  double largest_mismatch;  ///< of the two lengths of a seam, of the longer one
  double largest_gap;       ///< between the edges of a seam as the file places them, mm
};

class RealPattern : public ::testing::TestWithParam<File> {};

// Each file of real patterns becomes a garment of quadrilaterals alone, whose seams are its stitches, pair by pair, of
// lengths that agree, and no further apart in space than the file has them.
TEST_P(RealPattern, IsMeshedAndSewn) {
  const pattern::Pattern pattern = pattern::read_pattern(folder + GetParam().name);
  const Garment garment = build(scene_of(GetParam().name, 10.0));
  ASSERT_EQ(garment.mesh.panels.size(), pattern.panels.size());
  ASSERT_EQ(garment.seams.size(), pattern.stitches.size());
  for (const mesh::Block& block : garment.mesh.blocks) EXPECT_EQ(block.nodes_per_element, 4);
  double mismatch = 0.0, gap = 0.0;
  for (const Seam& seam : garment.seams) {
    ASSERT_EQ(seam.first_nodes.size(), seam.second_nodes.size());
    const double first = length_of(garment.mesh, seam.first_nodes), second = length_of(garment.mesh, seam.second_nodes);
    mismatch = std::max(mismatch, std::abs(first - second) / std::max(first, second));
    for (std::size_t k = 0; k < seam.first_nodes.size(); ++k)
      gap =
          std::max(gap, (garment.mesh.placed[seam.first_nodes[k]] - garment.mesh.placed[seam.second_nodes[k]]).norm());
  }
  RecordProperty("mismatch", std::to_string(mismatch));
  RecordProperty("gap", std::to_string(gap));
  EXPECT_LE(mismatch, GetParam().largest_mismatch);
  EXPECT_LE(gap, GetParam().largest_gap);
}

// Nodes lie where the file's rotation and translation put them, with its y axis up and its z axis to the front, and the
// right side of each panel shows away from the wearer.
TEST_P(RealPattern, LiesWhereTheFileSays) {
  const pattern::Pattern pattern = pattern::read_pattern(folder + GetParam().name);
  Teuchos::ParameterList scene = scene_of(GetParam().name, 40.0);
  scene.sublist("Pattern").sublist("Placement").set("origin", reals({1.0, 2.0, 3.0}));
  const mesh::Mesh mesh = build(scene).mesh;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& at : mesh.placed) middle += at / static_cast<double>(mesh.nodes());
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const pattern::Panel& panel = pattern.panels[p];
    for (const pattern::Edge& edge : panel.outline) {
      const pattern::Vec2 corner = edge.curve.front();
      const Vec3 file = panel.placement->rotation * Vec3(corner.x(), corner.y(), 0.0) + panel.placement->translation;
      const int node = mesh.edges.at(panel.name + "." + edge.name).front();
      EXPECT_LE((mesh.placed[node] - Vec3(file.x() + 1.0, 2.0 - file.z(), file.y() + 3.0)).norm(), 1e-9)
          << panel.name << "." << edge.name;
    }
    Vec3 centre = Vec3::Zero();
    for (int n = 0; n < mesh.panels[p].nodes; ++n)
      centre += mesh.placed[mesh.panels[p].first + n] / static_cast<double>(mesh.panels[p].nodes);
    const Vec3 normal = mesh.normal[mesh.panels[p].first];
    if (std::abs(normal.y()) > 0.9) {
      EXPECT_GT(normal.y() * (centre - middle).y(), 0.0) << panel.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealPattern,
                         ::testing::Values(File{"gpg_tee.json", 1e-15, 350.0},
                                           File{"gpg_tee_sleeveless.json", 1e-15, 350.0},
                                           File{"garmentcode_shirt_mean_specification.json", 0.005, 460.0}));

/// A file with one square panel and a dart, of which one side may be longer.
std::string write_dart(double longer) {
  std::string path = ::testing::TempDir() + "dart.json";
  std::ofstream(path) << R"({"properties": {"curvature_coords": "relative", "units_in_meter": 1000}, "pattern": {
    "panels": {"back": {"vertices": [[0, 0], [100, 0], [100, 100], [60, )"
                      << 100.0 + longer
                      << R"(], [50, 50], [40, 100], [0, 100]], "translation": [0, 0, 0], "rotation": [0, 0, 0],
      "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 4]},
                {"endpoints": [4, 5]}, {"endpoints": [5, 6]}, {"endpoints": [6, 0]}]}},
    "stitches": [[{"panel": "back", "edge": 3}, {"panel": "back", "edge": 4}]]}})";
  return path;
}

// The sides of a dart are sewn to each other from its tip, which stays one node.
TEST(WholePattern, SewsDarts) {
  const Garment garment = build(scene_of(write_dart(0.0), 8.0));
  ASSERT_EQ(garment.seams.size(), 1u);
  const Seam& seam = garment.seams[0];
  EXPECT_EQ(seam.pairs.size() + 1, seam.first_nodes.size());
  for (const auto& [a, b] : seam.pairs) {
    const mesh::Vec2 one = garment.mesh.pattern[a], other = garment.mesh.pattern[b];
    EXPECT_NEAR(one.x() + other.x(), 100.0, 1e-9);
    EXPECT_NEAR(one.y(), other.y(), 1e-9);
  }
}

// Edges of a stitch whose lengths differ by more than "ease" are refused with both lengths.
TEST(WholePattern, RefusesMoreThanEase) {
  Teuchos::ParameterList scene = scene_of(write_dart(10.0), 8.0);
  EXPECT_THAT(input_error([&] { build(scene); }), AllOf(HasSubstr("60.8276 mm"), HasSubstr("50.9902 mm"),
                                                        HasSubstr("differ by more than 5 % (parameter \"ease\")")));
  scene.sublist("Pattern").set("ease", 0.2);
  EXPECT_EQ(build(scene).seams.size(), 1u);
}

// An entry of "Panels" or "Seams" keeps what it says, and the file fills in the rest.
TEST(WholePattern, EntriesGoBefore) {
  Teuchos::ParameterList scene = scene_of("gpg_tee.json", 20.0);
  const std::string name = pattern::read_pattern(folder + "gpg_tee.json").panels.front().name;
  scene.sublist("Panels").sublist(name).set("material", std::string("rib"));
  scene.sublist("Seams").sublist("stitch0").set("ease", 0.5);
  const base::List list = read(scene);
  for (const base::List& panel : list.list("Panels").entries()) {
    EXPECT_EQ(panel.word("material"), panel.name() == name ? "rib" : "knit");
    EXPECT_EQ(panel.real("element size"), 20.0);
    EXPECT_EQ(panel.list("Placement").word("type"), "from pattern");
  }
  for (const base::List& seam : list.list("Seams").entries())
    EXPECT_EQ(seam.real("ease"), seam.name() == "stitch0" ? 0.5 : 0.05);
}

// What is wrong with the list is told with its file, list and parameter.
TEST(WholePattern, WrongListsAreRefused) {
  EXPECT_THAT(input_error([] { read(scene_of("gpg_te.json", 20.0)); }),
              AllOf(HasSubstr("scene.xml: scene > Pattern: parameter \"file\""), HasSubstr("gpg_te.json")));
  EXPECT_THAT(input_error([] { read(scene_of("gpg_tee.json", -20.0)); }),
              HasSubstr("scene > Pattern: parameter \"element size\" is out of range: -20 mm, allowed: > 0 mm"));
  Teuchos::ParameterList skew = scene_of("gpg_tee.json", 40.0);
  skew.sublist("Pattern").sublist("Placement").set("front", reals({0.0, -1.0, 1.0}));
  EXPECT_THAT(input_error([&] { build(skew); }), HasSubstr("\"front\" = {0, -1, 1}: must be perpendicular to \"up\""));
}

/// A square of 100 mm with free elements and some internal lines, each two points.
Teuchos::ParameterList square_scene(const std::vector<std::vector<double>>& lines) {
  Teuchos::ParameterList scene("scene");
  Teuchos::ParameterList& panel = scene.sublist("Panels").sublist("front");
  panel.set("material", std::string("knit"));
  panel.set("shape", std::string("outline"));
  panel.set("mesher", std::string("free"));
  panel.set("element size", 20.0);
  panel.sublist("Outline").sublist("round").set("curve", std::string("polyline"));
  panel.sublist("Outline").sublist("round").set("points", reals({0, 0, 100, 0, 100, 100, 0, 100, 0, 0}));
  for (std::size_t k = 0; k < lines.size(); ++k)
    panel.sublist("Lines")
        .sublist("line" + std::to_string(k))
        .set("points", Teuchos::Array<double>(lines[k].begin(), lines[k].end()));
  return scene;
}

base::List panels_of(const Teuchos::ParameterList& scene) {
  return base::validate(scene, base::Spec("scene", "").list(panels_spec()), "scene.xml").list("Panels");
}

base::List square(const std::vector<std::vector<double>>& lines) {
  return panels_of(square_scene(lines));
}

// A whole ring, whose ends lie on each other, is refused by the free mesher with the reason and the way out; one with a
// gap is meshed.
TEST(FreePanel, EdgesOnEachOtherAreRefused) {
  const auto ring = [](double angle) {
    Teuchos::ParameterList scene("scene");
    Teuchos::ParameterList& panel = scene.sublist("Panels").sublist("ring");
    panel.set("material", std::string("knit")).set("shape", std::string("sector"));
    panel.set("inner radius", 60.0).set("outer radius", 100.0).set("to angle", angle);
    panel.set("mesher", std::string("free")).set("element size", 10.0);
    return panels_of(scene);
  };
  EXPECT_EQ(build_panels(ring(350.0), nullptr).size(), 1u);
  EXPECT_THAT(input_error([&] { build_panels(ring(360.0), nullptr); }),
              AllOf(HasSubstr("scene > Panels > ring: parameter \"mesher\""),
                    HasSubstr("edges lie on each other, as \"left\" and \"right\" do"), HasSubstr("\"structured\"")));
}

// Elements that are to be finer at a corner are so on the edges as well: their sides grow from 2 mm there to 20 mm.
TEST(FreePanel, EdgesAreFinerWhereThePanelIs) {
  Teuchos::ParameterList scene = square_scene({});
  Teuchos::ParameterList& finer = scene.sublist("Panels").sublist("front").sublist("Sizes").sublist("corner");
  finer.set("at point", reals({0.0, 0.0})).set("size", 2.0).set("distance", 60.0);
  const mesh::PanelMesh mesh = build_panels(panels_of(scene), nullptr)[0].mesh;
  const std::vector<int>& round = mesh.edges.at("round");
  for (std::size_t k = 1; k < round.size(); ++k) {
    const mesh::Vec2 &a = mesh.nodes[round[k - 1]], &b = mesh.nodes[round[k]];
    const double wanted = std::min(20.0, 2.0 + 0.3 * (0.5 * (a + b)).norm());
    EXPECT_LT((b - a).norm(), 1.1 * wanted) << 0.5 * (a + b).transpose();
    EXPECT_GT((b - a).norm(), 0.6 * wanted) << 0.5 * (a + b).transpose();
  }
}

// An internal line may end on edges and other lines; one that leaves the panel or crosses another is refused.
TEST(FreePanel, LinesThatCannotBeMeshedAreRefused) {
  EXPECT_EQ(build_panels(square({{0, 50, 100, 50}, {50, 50, 50, 100}}), nullptr).size(), 1u);
  EXPECT_THAT(input_error([] {
                build_panels(square({{50, 50, 150, 50}}), nullptr);
              }),
              AllOf(HasSubstr("scene.xml: scene > Panels > front: parameter \"mesher\""),
                    HasSubstr("line \"line0\" leaves the panel near (100, 50) mm")));
  EXPECT_THAT(input_error([] {
                build_panels(square({{20, 50, 80, 50}, {50, 20, 50, 80}}), nullptr);
              }),
              HasSubstr("lines \"line0\" and \"line1\" cross near (50, 50) mm"));
}

}  // namespace
}  // namespace toile::garment::test
