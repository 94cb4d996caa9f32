// A sewing pattern that is put on a body by one command.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "column.hpp"
#include "exodus.hpp"
#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

constexpr double radius = 60.0, half_width = 85.0;  // mm

/// A tube of two rectangles, 340 x 120 mm.
const std::string tube = R"({"pattern": {"panels": {
  "front": {"vertices": [[-85, 0], [85, 0], [85, 120], [-85, 120]], "translation": [0, 0, 100], "rotation": [0, 0, 0],
    "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]},
  "back": {"vertices": [[-85, 0], [-85, 120], [85, 120], [85, 0]], "translation": [0, 0, -100], "rotation": [0, 0, 0.0],
    "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, {"endpoints": [3, 0]}]}},
  "stitches": [[{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}],
               [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 0}]]},
  "properties": {"curvature_coords": "relative", "normalize_panel_translation": false, "units_in_meter": 1000}})";

class Dress : public ProgramTest {
 protected:
  void SetUp() override { write("column.obj", column(radius)); }

  /// What `toile dress` says of the tube with a text of it replaced, which must be refused.
  std::string refusal(const std::string& from, const std::string& to, const std::string& options) {
    std::string text = tube;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    write("tube.json", text.replace(at, from.size(), to));
    const Outcome outcome = toile("dress tube.json column.obj --output out " + options);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    return outcome.err;
  }
};

/// Hoop tension over radius of the T-shirt fabric, of 1 mm, stretched along its course; kPa.
double pressure_of_tube() {
  double stretch = 2.0 * M_PI * radius / (4.0 * half_width), thickness = 1.0;
  for (int k = 0; k < 20; ++k) {
    thickness = 1.0 / std::sqrt(stretch);
    stretch = 2.0 * M_PI * (radius + 0.5 * thickness) / (4.0 * half_width);
  }
  const double e = std::log(stretch);
  const double fibres = e * (-0.010 + e * (0.0206 / 2.0 + e * (0.0291 / 3.0 - e * 0.013 / 4.0)));  // MPa
  const double hoop = 2.0 * 3.82e-2 * (stretch * stretch - 1.0 / stretch) + fibres;
  return 1e3 * hoop * thickness / (radius + 0.5 * thickness);
}

// The pressure of a tube of two panels is that of its even hoop tension over the radius; scene and pattern are kept.
TEST_F(Dress, ATubeHasThePressureOfItsTension) {
  write("tube.json", tube);
  const Outcome outcome = toile("dress tube.json column.obj --output out --hem 140 --size 9");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const ExodusStep last(path("out/results.exo"));
  const std::vector<double> pressure = last.nodal("pressure"), area = last.nodal("area");
  const auto nodes = static_cast<size_t>(std::find(area.begin(), area.end(), 0.0) - area.begin());
  ASSERT_GT(nodes, 500U);
  double largest = 0.0;
  for (size_t n = 0; n < nodes; ++n) largest = std::max(largest, std::abs(pressure[n] / pressure_of_tube() - 1.0));
  EXPECT_LT(largest, 0.03);
  EXPECT_THAT(outcome.out, HasSubstr("front: 0 % loose, elsewhere"));
  EXPECT_THAT(outcome.out, HasSubstr("stretched to 1.11 times its width; with --scale 1.11 its tightest place would"));
  EXPECT_EQ(toile("check out/scene.xml").status, 0);
}

// A pattern that is far too small or too large for its body is refused with the scale that would fit.
TEST_F(Dress, TellsTheScaleThatFits) {
  EXPECT_THAT(refusal("1000", "1000", "--hem 140 --scale 0.4"),
              AllOf(HasSubstr("the pattern is too small: the garment measures 136 mm round the trunk"),
                    HasSubstr("stretched to 2.77 times its width"), HasSubstr("with --scale 1.11 its tightest")));
  EXPECT_THAT(refusal("1000", "250", "--hem 140"),
              AllOf(HasSubstr("the pattern is too large"), HasSubstr("3.6 times as much"),
                    HasSubstr("with --scale 0.28 its tightest")));
}

// A garment that is loose everywhere is told before it is run; one that is tight somewhere is not.
TEST_F(Dress, TellsThatItIsLoose) {
  write("tube.json", tube);
  const std::string command = "dress tube.json column.obj --output out --hem 140 --only-scene";
  EXPECT_THAT(toile(command + " --scale 1.3").out, HasSubstr("loose everywhere: little will press"));
  EXPECT_THAT(toile(command).out, Not(HasSubstr("loose everywhere")));
}

// What cannot be dressed is refused by its reason: no height, elements too long, panels across or none behind, a
// body of another unit.
TEST_F(Dress, RefusesWhatCannotBePlaced) {
  EXPECT_THAT(refusal("1000", "1000", ""), HasSubstr("no seam joins front and back on the shoulders"));
  EXPECT_THAT(refusal("1000", "1000", "--hem 140 --size 60"), HasSubstr("elements of 60 mm (--size) are too long"));
  EXPECT_THAT(refusal("1000", "1000", "--hem 600"),
              AllOf(HasSubstr("the body is not where the pattern is"), HasSubstr("at heights of 602 to 718 mm"),
                    HasSubstr("The garment measures 340 mm round at most"), HasSubstr("is --hem too high")));
  EXPECT_THAT(refusal("[0, 0, 0]", "[0, 90, 0]", "--hem 140"), HasSubstr("panel \"front\" lies across the front"));
  EXPECT_THAT(refusal("\"translation\": [0, 0, -100]", "\"translation\": [400, 0, -100]", "--hem 140"),
              HasSubstr("no panel lies behind the trunk"));
  EXPECT_THAT(refusal(R"([{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}],)", "", "--hem 140"),
              HasSubstr("back.edge2\" goes up from the hem and no stitch sews it to the trunk"));
  write("column.obj", column(radius, 1000.0));
  EXPECT_THAT(refusal("1000", "1000", "--hem 140"), HasSubstr("1000"));
}

// A pattern that cannot be sewn is refused by name: a panel that does not close, a stitch to an edge that is missing,
// sides of a seam whose lengths differ.
TEST_F(Dress, RefusesWhatCannotBeSewn) {
  EXPECT_THAT(refusal("[3, 0]}]},\n  \"back\"", "[3, 1]}]},\n  \"back\"", "--hem 140"), HasSubstr("front"));
  EXPECT_THAT(refusal("\"edge\": 2", "\"edge\": 7", "--hem 140"),
              HasSubstr("edge: expected a whole number from 0 to 3"));
  EXPECT_THAT(refusal("[85, 120], [-85, 120]", "[85, 150], [-85, 150]", "--hem 140"), HasSubstr("ease"));
}

// A T-shirt with sleeves of one panel is dressed by one command: they start round the arms, and the seams close.
TEST_F(Dress, WholeSleevesStartRoundTheArms) {
  const Outcome outcome = toile("dress " TOILE_SOURCE_DIR "/input/patterns/tshirt.json " TOILE_SOURCE_DIR
                                "/input/bodies/female_body.obj --output out --only-scene --size 20");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("left sleeve: left_sleeve (whole)"), HasSubstr("right sleeve: right_sleeve (whole)")));
  const Outcome start = toile("check out/scene.xml");
  EXPECT_EQ(start.status, 0) << start.err;
  EXPECT_THAT(start.out, HasSubstr("left_sleeve.underarm_back to left_sleeve.underarm_front, 0 mm apart"));
}

// A shirt that is a third wider than the woman who wears it comes to rest: it lies on the shoulders and presses nowhere
// else.
TEST_F(Dress, ALooseShirtComesToRest) {
  const Outcome outcome =
      toile("dress " TOILE_SOURCE_DIR "/test/data/patterns/garmentcode_shirt_mean_specification.json " TOILE_SOURCE_DIR
            "/input/bodies/female_body.obj --output out --size 20");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("loose everywhere"), HasSubstr("stable (no negative pivot)")));
}

// The tee of a pattern generator on a woman's body: its panels are told apart, and their girths from hers.
TEST_F(Dress, ComparesATeeWithAWoman) {
  const Outcome outcome = toile("dress " TOILE_SOURCE_DIR "/test/data/patterns/gpg_tee.json " TOILE_SOURCE_DIR
                                "/input/bodies/female_body.obj --output out --only-scene");
  const Outcome small =
      toile("dress " TOILE_SOURCE_DIR "/test/data/patterns/garmentcode_shirt_mean_specification.json " TOILE_SOURCE_DIR
            "/input/bodies/female_body.obj --output out --only-scene --scale 0.7");
  EXPECT_EQ(small.status, 0) << small.err;
  // Above the armpits a section goes round the arms as well: 1100 mm, which is no girth of the trunk.
  EXPECT_THAT(small.out, Not(HasSubstr(", body 1")));
  // At 0.6 of its size, the shirt ends above the armpits.
  const Outcome short_one =
      toile("dress " TOILE_SOURCE_DIR "/test/data/patterns/garmentcode_shirt_mean_specification.json " TOILE_SOURCE_DIR
            "/input/bodies/female_body.obj --output out --only-scene --scale 0.6");
  EXPECT_EQ(short_one.status, 2);
  EXPECT_THAT(short_one.err, HasSubstr("nothing of the trunk lies round the body below its armpits"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("trunk: back (back), front (front)"),
                                 HasSubstr("left sleeve: lbsleeve (back), lfsleeve (front)"),
                                 HasSubstr("right sleeve: rbsleeve (back), rfsleeve (front)")));
  // Two panels of 130 units of a 300th of a metre; the bust is 830 mm.
  EXPECT_THAT(outcome.out, HasSubstr("trunk at height 1162 mm: garment 867, body 8"));
  EXPECT_TRUE(exists("out/scene.xml") && exists("out/pattern.json"));
}

/// A panel of straight edges, in front (z > 0) or behind.
std::string panel(const std::string& name, double z, const std::vector<std::pair<int, int>>& corners) {
  std::ostringstream text;
  text << '"' << name << R"(": {"translation": [0, 0, )" << z << R"(], "rotation": [0, 0, 0], "vertices": [)";
  for (size_t c = 0; c < corners.size(); ++c)
    text << (c == 0 ? "[" : ", [") << corners[c].first << ", " << corners[c].second << ']';
  text << R"(], "edges": [)";
  for (size_t c = 0; c < corners.size(); ++c)
    text << (c == 0 ? "" : ", ") << R"({"endpoints": [)" << c << ", " << (c + 1) % corners.size() << "]}";
  return text.str() + "]}";
}

// A sleeve that is far too narrow for the arm is refused by its name, with both girths.
TEST_F(Dress, RefusesASleeveThatIsTooNarrow) {
  const std::vector<std::pair<int, int>> trunk = {{-240, 0}, {240, 0},   {240, 450},  {240, 600},
                                                  {80, 600}, {-80, 600}, {-240, 600}, {-240, 450}},
                                         sleeve = {{250, 560}, {350, 560}, {350, 600}, {250, 600}};
  const auto stitch = [](const char* first, int i, const char* second, int j) {
    return R"([{"panel": ")" + std::string(first) + R"(", "edge": )" + std::to_string(i) + R"(}, {"panel": ")" +
           second + R"(", "edge": )" + std::to_string(j) + "}]";
  };
  write("tee.json", R"({"pattern": {"panels": {)" + panel("front", 100, trunk) + ", " + panel("back", -100, trunk) +
                        ", " + panel("sleeve_f", 100, sleeve) + ", " + panel("sleeve_b", -100, sleeve) +
                        R"(}, "stitches": [)" + stitch("front", 3, "back", 3) + ", " + stitch("front", 5, "back", 5) +
                        ", " + stitch("front", 1, "back", 1) + ", " + stitch("front", 7, "back", 7) + ", " +
                        stitch("front", 2, "sleeve_f", 3) + ", " + stitch("back", 2, "sleeve_b", 3) + ", " +
                        stitch("sleeve_f", 0, "sleeve_b", 0) + ", " + stitch("sleeve_f", 2, "sleeve_b", 2) +
                        R"(]}, "properties": {"units_in_meter": 1000}})");
  const Outcome outcome =
      toile("dress tee.json " TOILE_SOURCE_DIR "/input/bodies/female_body.obj --output out --only-scene");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("the pattern is too small: the garment measures 80 mm round the left sleeve"),
                    HasSubstr("and the body 2")));
}

}  // namespace
}  // namespace toile::test
