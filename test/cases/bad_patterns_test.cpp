// Patterns that do not fit their body or cannot be sewn, in a scene and by `toile dress`: refused with what is wrong.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/column.hpp"
#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class BadPattern : public ProgramTest {
 protected:
  void SetUp() override { write("column.obj", column(60.0)); }

  /// A tube of two rectangles, each `width` mm wide and 120 mm high, in tube.json.
  void write_tube(double width, const std::string& from = "", const std::string& to = "") {
    std::ostringstream x;
    x << width / 2.0;
    const std::string edges = R"("edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 3]}, )";
    const std::string l = "[-" + x.str(), r = "[" + x.str();
    std::string text = R"({"pattern": {"panels": {
      "front": {"vertices": [)" +
                       l + ", 0], " + r + ", 0], " + r + ", 120], " + l +
                       R"(, 120]], "translation": [0, 0, 100], "rotation": [0, 0, 0], )" + edges +
                       R"({"endpoints": [3, 0]}]},
      "back": {"vertices": [)" +
                       l + ", 0], " + l + ", 120], " + r + ", 120], " + r +
                       R"(, 0]], "translation": [0, 0, -100], "rotation": [0, 0, 0], )" + edges +
                       R"({"endpoints": [3, 0]}]}},
      "stitches": [[{"panel": "front", "edge": 1}, {"panel": "back", "edge": 2}],
                   [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 0}]]},
      "properties": {"curvature_coords": "relative", "normalize_panel_translation": false, "units_in_meter": 1000}})";
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    write("tube.json", text.replace(place, from.size(), to));
  }

  /// The scene that drapes and settles tube.json on column.obj.
  void write_tube_scene(const std::string& of_body = "") {
    write("tube.xml", R"xml(<ParameterList name="scene">
      <ParameterList name="Body"><Parameter name="type" type="string" value="file"/>
        <Parameter name="file" type="string" value="column.obj"/>)xml" +
                          of_body + R"xml(</ParameterList>
      <ParameterList name="Materials"><ParameterList name="knit"><Parameter name="type" type="string" value="rebar"/>
        <Parameter name="set" type="string" value="t-shirt"/>
        <Parameter name="compression" type="string" value="tension field"/></ParameterList></ParameterList>
      <ParameterList name="Pattern"><Parameter name="file" type="string" value="tube.json"/>
        <Parameter name="material" type="string" value="knit"/>
        <Parameter name="element size" type="double" value="12"/>
        <ParameterList name="Placement"><Parameter name="origin" type="Array(double)" value="{0, 0, 140}"/>
        </ParameterList></ParameterList>
      <ParameterList name="Drape"/>
      <ParameterList name="Supports"><ParameterList name="hem">
        <Parameter name="on" type="Array(string)" value="{front.edge0, back.edge3}"/>
        <Parameter name="hold" type="string" value="z"/></ParameterList></ParameterList>
      <ParameterList name="Stages"><ParameterList name="settle"><Parameter name="type" type="string" value="settle"/>
        <ParameterList name="Damping"/></ParameterList></ParameterList>
    </ParameterList>)xml");
  }

  std::string scene_refusal() {
    write_tube_scene();
    const Outcome outcome = toile("run tube.xml --output out");
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    return outcome.err;
  }
  std::string dress_refusal(const std::string& options = "") {
    const Outcome outcome = toile("dress tube.json column.obj --hem 140 --output worn " + options);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    return outcome.err;
  }
};

// A panel that does not close is refused with the file, the panel and the two points.
TEST_F(BadPattern, PanelThatDoesNotClose) {
  write_tube(170.0, "[3, 0]}]},", "[3, 1]}]},");
  for (const std::string& message : {scene_refusal(), dress_refusal()})
    EXPECT_THAT(message,
                HasSubstr("tube.json: panel \"front\": the outline is open: edge \"edge3\" ends at (85, 0) mm, "
                          "and edge \"edge0\" starts at (-85, 0) mm; they must be the same point"));
}

// A stitch to an edge or a panel that is missing is refused with the stitch, its side and what there is.
TEST_F(BadPattern, StitchToWhatIsMissing) {
  write_tube(170.0, R"("panel": "back", "edge": 2)", R"("panel": "back", "edge": 7)");
  for (const std::string& message : {scene_refusal(), dress_refusal()})
    EXPECT_THAT(message,
                HasSubstr("tube.json: stitch 0, second side, edge: expected a whole number from 0 to 3, found 7"));
  write_tube(170.0, R"("panel": "back", "edge": 2)", R"("panel": "bakc", "edge": 2)");
  for (const std::string& message : {scene_refusal(), dress_refusal()})
    EXPECT_THAT(message, HasSubstr("tube.json: stitch 0, second side, panel: there is no panel \"bakc\"; did you mean "
                                   "\"back\"?"));
}

// An entry of the scene for a panel that the pattern does not have is refused with the nearest name, and a fabric that
// is not there before the body is looked at.
TEST_F(BadPattern, NamesThatAreNotThere) {
  write_tube(170.0);
  write_tube_scene();
  const std::string scene = read("tube.xml"), panels = R"(<ParameterList name="Panels"><ParameterList name="fornt">
    <Parameter name="wale angle" type="double" value="0"/></ParameterList></ParameterList>)";
  write("panel.xml", scene.substr(0, scene.rfind("</")) + panels + scene.substr(scene.rfind("</")));
  EXPECT_THAT(toile("check panel.xml").err,
              AllOf(HasSubstr("panel.xml: scene > Panels > fornt: the pattern"),
                    HasSubstr("tube.json has no panel of this name"), HasSubstr("did you mean \"front\"?")));
  std::filesystem::remove(path("column.obj"));
  write("fabric.xml", scene.substr(0, scene.find("\"knit\"/>")) + "\"nkit\"/>" +
                          scene.substr(scene.find("\"knit\"/>") + std::string("\"knit\"/>").size()));
  EXPECT_THAT(toile("check fabric.xml").err, HasSubstr("did you mean \"knit\"?"));
}

// So is every name of an edge: of seams, supports, loads, points and distances.
TEST_F(BadPattern, EdgesThatAreNotThere) {
  write_tube(170.0);
  write_tube_scene();
  std::filesystem::remove(path("column.obj"));
  const std::string scene = read("tube.xml");
  const auto said = [&](const std::string& list, const std::string& content) {
    std::string other = scene;
    const std::string open = "<ParameterList name=\"" + list + "\">";
    if (const std::size_t at = scene.find(open); at != std::string::npos)
      other.insert(at + open.size(), content);
    else
      other.insert(scene.rfind("</"), open + content + "</ParameterList>");
    write("edge.xml", other);
    return toile("check edge.xml").err;
  };
  const auto entry = [](const std::string& parameters) {
    return "<ParameterList name=\"one\">" + parameters + "</ParameterList>";
  };
  const auto word = [](const std::string& name, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"string\" value=\"" + value + "\"/>";
  };
  const std::string on = R"xml(<Parameter name="on" type="Array(string)" value="{front.edgge0}"/>)xml",
                    traction = R"xml(<Parameter name="traction" type="Array(double)" value="{0, 0, 1}"/>)xml",
                    points = "<ParameterList name=\"Points\">", distances = "<ParameterList name=\"Distances\">";
  const auto expect_near = [](const std::string& message, const std::string& where) {
    EXPECT_THAT(message, AllOf(HasSubstr("edge.xml: scene > " + where), HasSubstr("front.edgge0"),
                               HasSubstr("did you mean \"front.edge0\"?")));
  };
  expect_near(said("Supports", entry(on + word("hold", "z"))), "Supports > one: parameter \"on\"");
  expect_near(said("Seams", entry(word("first", "front.edgge0") + word("second", "back.edge3"))),
              "Seams > one: parameter \"first\"");
  expect_near(said("Loads", entry(word("on", "front.edgge0") + traction)), "Loads > one: parameter \"on\"");
  expect_near(said("Output", points + entry(word("on", "front.edgge0@0.5")) + "</ParameterList>"),
              "Output > Points > one: parameter \"on\"");
  expect_near(said("Output", distances + entry(word("first", "front.edgge0") + word("second", "back.edge3")) +
                                 "</ParameterList>"),
              "Output > Distances > one: parameter \"first\"");
}

// Elements wider than a panel, a level beside the garment and a weight that no fabric has are told before anything is
// solved.
TEST_F(BadPattern, NumbersThatCannotBe) {
  write_tube(170.0);
  write_tube_scene();
  std::string scene = read("tube.xml");
  const std::string size = R"("element size" type="double" value="12")";
  scene.replace(scene.find(size), size.size(), R"("element size" type="double" value="5000")");
  scene.insert(scene.rfind("</"), R"(<ParameterList name="Output"><ParameterList name="Levels">
    <ParameterList name="knee"><Parameter name="height" type="double" value="900"/></ParameterList>
    <ParameterList name="middle"><Parameter name="height" type="double" value="200"/></ParameterList>
    </ParameterList></ParameterList>
    <ParameterList name="Loads"><ParameterList name="own"><Parameter name="type" type="string" value="weight"/>
    <Parameter name="area density" type="double" value="1.5e5"/></ParameterList></ParameterList>)");
  write("tube.xml", scene);
  const std::string said = toile("check tube.xml").err;
  EXPECT_THAT(said, HasSubstr("panel \"front\": \"element size\" = 5000 mm is wider than the panel allows"));
  EXPECT_THAT(said,
              HasSubstr("level \"knee\" is at a height of 900 mm, and the garment starts between 140 and 260 mm"));
  EXPECT_THAT(said, HasSubstr("load \"own\": \"area density\" = 150000 g/m^2 is no fabric's"));
  EXPECT_THAT(said, Not(HasSubstr("level \"middle\"")));
}

// Sides of a seam whose lengths differ beyond its ease are refused with both lengths, the difference and the way out.
TEST_F(BadPattern, SidesOfDifferentLengths) {
  write_tube(170.0, ", 120], [-85, 120]]", ", 150], [-85, 150]]");
  for (const std::string& message : {scene_refusal(), dress_refusal()})
    EXPECT_THAT(message, AllOf(HasSubstr("Seams > stitch0: parameter \"second\" = \"back.edge2\""),
                               HasSubstr("\"front.edge1\" ("), HasSubstr(", 150 mm) and \"back.edge2\" ("),
                               HasSubstr(", 120 mm) differ by more than 5 % (parameter \"ease\"): by 20 %"),
                               HasSubstr("give the seam a larger \"ease\"")));
}

// A pattern that is far too small stops before anything is solved, with the stretch that it would need: 377 mm of the
// body, and the drape's distance, over 100 mm.
TEST_F(BadPattern, FarTooSmall) {
  write_tube(50.0);
  const std::string message = scene_refusal();
  EXPECT_THAT(message, AllOf(HasSubstr("tube.xml: scene > Drape: the pattern is too small for the body"),
                             HasSubstr("times as wide would lie on it"), HasSubstr("knits stand 3")));
  const std::string before = "would need a stretch of ";
  const std::size_t at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  EXPECT_NEAR(std::stod(message.substr(at + before.size())), 2.0 * M_PI * 61.0 / 100.0, 0.1);
  EXPECT_THAT(dress_refusal(), AllOf(HasSubstr("the pattern is too small: the garment measures 100 mm round the trunk"),
                                     HasSubstr("stretched to 3.77 times its width")));
}

// A pattern that is too large to touch the body is refused instead of iterated on, with by how much it is too wide:
// 800 mm round a body of 377 mm.
TEST_F(BadPattern, FarTooLarge) {
  write_tube(400.0);
  const std::string message = scene_refusal();
  EXPECT_THAT(message, HasSubstr("tube.xml: scene > Drape: the garment touches the body nowhere"));
  const std::string before = "as if it were ";
  const std::size_t at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  EXPECT_NEAR(std::stod(message.substr(at + before.size())), 800.0 - 2.0 * M_PI * 60.0, 30.0);
  EXPECT_THAT(dress_refusal("--size 12"), HasSubstr("the garment touches the body nowhere"));
  write_tube(600.0);
  EXPECT_THAT(dress_refusal(), AllOf(HasSubstr("the pattern is too large: where it is tightest, the garment measures "
                                               "1200 mm round the trunk"),
                                     HasSubstr("with --scale 0.3")));
}

// A sleeve that is too narrow for its arm is refused by its name, with the stretch that it would need: the T-shirt at
// 0.7 of its size, whose sleeve of 212 mm has 148 mm left for an upper arm of 255 mm.
TEST_F(BadPattern, ArmThatDoesNotFitTheSleeve) {
  std::ostringstream shipped;
  shipped << std::ifstream(TOILE_SOURCE_DIR "/input/patterns/tshirt.json").rdbuf();
  std::string text = shipped.str();
  const std::string unit = "\"units_in_meter\": 1000";
  ASSERT_NE(text.find(unit), std::string::npos);
  write("tshirt.json", text.replace(text.find(unit), unit.size(), "\"units_in_meter\": 1428.571"));
  write("small.xml", R"xml(<ParameterList name="scene">
      <Parameter name="include" type="Array(string)" value="{)xml" TOILE_SOURCE_DIR R"xml(/input/tshirt-coarse.xml}"/>
      <ParameterList name="Pattern"><Parameter name="file" type="string" value="tshirt.json"/></ParameterList>
      <ParameterList name="Output"><Parameter name="remove" type="bool" value="true"/></ParameterList>
    </ParameterList>)xml");
  const Outcome outcome = toile("run small.xml");
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_THAT(outcome.err,
              ContainsRegex("scene > Drape: the pattern is too small for the body: to lie round it, half of "
                            "panel \"(left|right)_sleeve\" would need a stretch of 1[.]"));
}

// A body that is smaller than any person is refused with what is allowed, and so is one that is smaller than the cells
// of its smooth surface: with cells of its radius the pressure was 375 kPa instead of 0.4.
TEST_F(BadPattern, BodySmallerThanTheTolerance) {
  write_tube(170.0);
  write_tube_scene(R"(<Parameter name="scale" type="double" value="0.001"/>)");
  const Outcome tiny = toile("run tube.xml --output out");
  EXPECT_EQ(tiny.status, 2);
  EXPECT_THAT(tiny.err, HasSubstr("column.obj: the body is 0.4 mm high (z); allowed is 300 to 3000 mm"));
  write_tube_scene(R"(<Parameter name="cell" type="double" value="60"/>)");
  const Outcome coarse = toile("run tube.xml --output out");
  EXPECT_EQ(coarse.status, 2);
  EXPECT_THAT(coarse.err,
              HasSubstr("tube.xml: scene > Body: parameter \"cell\" = 60: is too large for this body, which "
                        "measures 120 mm across where it is thinnest; allowed is a third of that, 40 mm"));
}

}  // namespace
}  // namespace toile::test
