#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A scene that cannot be used: exit status 2, one message on the error stream, and the results of an earlier run in
/// the same folder stay as they are.
class BadInput : public ProgramTest {
 protected:
  void expect_refused(const std::string& message) const {
    write("out/results.exo", "of an earlier run");
    write("out/restart.h5", "of an earlier run");
    const Outcome run = toile("run scene.xml --output out");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, AllOf(StartsWith("toile: scene.xml"), HasSubstr(message)));
    EXPECT_EQ(read("out/results.exo"), "of an earlier run");
    EXPECT_EQ(read("out/restart.h5"), "of an earlier run");
  }
};

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

// An unknown parameter is named with its list and the nearest valid name.
TEST_F(BadInput, UnknownParameter) {
  write_scene("strip", {{"name=\"width\"", "name=\"widht\""}});
  expect_refused("scene > Panels > strip: unknown parameter \"widht\"; did you mean \"width\"? Valid here: ");
}

// Every problem of a scene is told at once, one line each.
TEST_F(BadInput, SeveralProblems) {
  write_scene("strip", {{"name=\"width\"", "name=\"widht\""}, {"\"set\"", "\"sett\""}});
  const std::string err = toile("check scene.xml").err;
  EXPECT_THAT(err, AllOf(HasSubstr("did you mean \"set\"?"), HasSubstr("\nscene.xml: scene > Panels > strip: "),
                         HasSubstr("did you mean \"width\"?")));
}

// A word where a number is expected.
TEST_F(BadInput, NotANumber) {
  write_scene("strip",
              {{"name=\"width\" type=\"double\" value=\"50\"", "name=\"width\" type=\"double\" value=\"wide\""}});
  expect_refused("scene > Panels > strip: parameter \"width\" is \"wide\", expected a number (double)");
}

// A value of another type is named with the type that is expected.
TEST_F(BadInput, WrongType) {
  write_scene("strip", {{"name=\"width\" type=\"double\"", "name=\"width\" type=\"string\""}});
  expect_refused("parameter \"width\" is \"50\" (string), expected double in mm");
}

// A value out of its range is shown beside the range.
TEST_F(BadInput, OutOfRange) {
  write_scene("strip", {{"type=\"double\" value=\"50\"", "type=\"double\" value=\"-50\""}});
  expect_refused("parameter \"width\" is out of range: -50 mm, allowed: > 0 mm");
}

// A scene that is not there.
TEST_F(BadInput, MissingScene) {
  const Outcome run = toile("run nowhere.xml");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "toile: nowhere.xml: cannot open this file: No such file or directory\n");
}

// A folder in place of the scene.
TEST_F(BadInput, FolderInPlaceOfTheScene) {
  write("folder/file", "");
  const Outcome run = toile("run folder");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.err, "toile: folder: this is a folder, expected an XML file\n");
}

// A file that is not XML is refused with the line of the mistake.
TEST_F(BadInput, XmlSyntax) {
  write("scene.xml", "<ParameterList name=\"scene\">\n  <Parameter name=\"title\"\n</ParameterList>\n");
  expect_refused("not well-formed XML: ");
  EXPECT_THAT(toile("check scene.xml").err, HasSubstr("line 3"));
}

// An empty file is no scene.
TEST_F(BadInput, EmptyScene) {
  write("scene.xml", "<ParameterList name=\"scene\"/>\n");
  expect_refused("missing list \"Materials\"");
}

// A support on an edge that no panel has.
TEST_F(BadInput, UnknownEdge) {
  write_scene("strip", {{"{strip.bottom}", "{strip.botom}"}});
  expect_refused(
      "scene > Supports > lower clamp: parameter \"on\" = {\"strip.botom\"}: no edge or panel is named "
      "\"strip.botom\"; did you mean \"strip.bottom\"? Valid here: strip, strip.bottom, strip.left, ");
}

// A seam on an edge that no panel has.
TEST_F(BadInput, UnknownEdgeOfASeam) {
  write_scene("sleeve", {{"sleeve.right", "sleeve.rigth"}});
  expect_refused(
      "scene > Seams > side: parameter \"second\" = \"sleeve.rigth\": there is no edge \"sleeve.rigth\"; "
      "did you mean \"sleeve.right\"? Valid here: ");
}

// A seam between edges with different numbers of nodes.
TEST_F(BadInput, SeamWithUnequalNodes) {
  write_scene("sleeve", {{"sleeve.right", "sleeve.top"}});
  expect_refused(
      "a seam whose edges cannot match: \"sleeve.left\" (10 nodes, 100 mm) and \"sleeve.top\" (21 nodes, "
      "200 mm) have different numbers of nodes; give both panels the same number of elements there");
}

// A seam between edges whose lengths differ by more than its ease.
TEST_F(BadInput, SeamWithUnequalLengths) {
  write_scene("sleeve", {{"sleeve.right", "sleeve.top"}, {"\"int\" value=\"20\"", "\"int\" value=\"9\""}});
  expect_refused(
      "a seam whose edges cannot match: the lengths of \"sleeve.left\" (10 nodes, 100 mm) and "
      "\"sleeve.top\" (10 nodes, 200 mm) differ by more than 5 % (parameter \"ease\")");
}

// A panel whose outline crosses itself.
TEST_F(BadInput, PanelThatOverlapsItself) {
  write_scene("strip", {{"value=\"rectangle\"/>", "value=\"four-sided\"/>" +
                                                      parameter("bottom", "Array(double)", "{0, 0, 50, 0}") +
                                                      parameter("right", "Array(double)", "{50, 0, 0, 100}") +
                                                      parameter("top", "Array(double)", "{50, 100, 0, 100}") +
                                                      parameter("left", "Array(double)", "{0, 0, 50, 100}")},
                        {parameter("width", "double", "50"), ""},
                        {parameter("height", "double", "100"), ""}});
  expect_refused("panel \"strip\": it overlaps itself near (25, 50) mm of its pattern; its outline must not cross");
}

// The published T-shirt weights as printed violate the conditions of the material, and the message says what to do.
TEST_F(BadInput, MaterialThatViolatesItsConditions) {
  write_scene("strip", {{"value=\"pantyhose\"", "value=\"t-shirt as printed\""}});
  expect_refused(
      "scene > Materials > fabric: parameter \"set\" = \"t-shirt as printed\": parameter \"w2_2\": the weights of term "
      "2 add up to 1.02, so w_3 = 1 - w_1 - w_2 = -0.02 is negative: J can turn negative and the energy is not "
      "polyconvex; set \"normalise weights\" to true to divide the weights by their sum");
}

// A panel of a material that the scene does not have.
TEST_F(BadInput, UnknownMaterial) {
  write_scene("strip", {{"name=\"material\" type=\"string\" value=\"fabric\"",
                         "name=\"material\" type=\"string\" value=\"fabirc\""}});
  expect_refused(
      "scene > Panels > strip: parameter \"material\" = \"fabirc\": no entry of the list \"Materials\" has "
      "this name; did you mean \"fabric\"? Valid here: fabric");
}

// A stage that sews in a scene without seams.
TEST_F(BadInput, SewingWithoutSeams) {
  write_scene("strip", {{"value=\"load\"", "value=\"sew\""}});
  expect_refused("scene > Stages > pull: parameter \"type\" = \"sew\": the scene has no list \"Seams\"");
}

// Contact with a body that the scene does not have.
TEST_F(BadInput, ContactWithoutBody) {
  write_scene("strip", {{"<ParameterList name=\"Stages\">",
                         "<ParameterList name=\"Contact\"/><ParameterList name=\"Stages\">"}});
  expect_refused("scene > Contact: the scene has no list \"Body\" to be in contact with");
}

// Pressure of a scene without a body.
TEST_F(BadInput, PressureWithoutBody) {
  write_scene("strip", {{"<ParameterList name=\"Output\">",
                         "<ParameterList name=\"Output\">" + parameter("stations", "int", "5")}});
  expect_refused("scene > Output: parameter \"stations\" = 5: the scene has no list \"Body\", so there is no pressure");
}

// Two supports that move the same node differently.
TEST_F(BadInput, ContradictorySupports) {
  write_scene("strip", {{"{strip.bottom}", "{strip.bottom, strip.left}"}});
  expect_refused(
      "scene > Supports > upper clamp: parameter \"move by\" = {0, 20, 0}: contradicts support \"lower "
      "clamp\": both hold the node at (0, 100, 0) mm in y, but \"upper clamp\" moves it by 20 mm and \"lower "
      "clamp\" by 0 mm");
}

// Two supports that move the same node as far, but at other loads.
TEST_F(BadInput, SupportsAtOtherLoads) {
  const std::string move = parameter("move by", "Array(double)", "{0, 20, 0}");
  write_scene("strip", {{"<ParameterList name=\"upper clamp\">",
                         "<ParameterList name=\"late\">" + parameter("on", "Array(string)", "{strip.top}") +
                             parameter("hold", "string", "y") + move + parameter("loads", "Array(double)", "{0.5, 1}") +
                             parameter("shares", "Array(double)", "{0, 1}") +
                             "</ParameterList><ParameterList name=\"upper clamp\">"}});
  expect_refused(
      "scene > Supports > upper clamp: parameter \"move by\" = {0, 20, 0}: contradicts support \"late\": both hold "
      "the node at (0, 100, 0) mm in y, but \"upper clamp\" moves it by 20 mm and \"late\" by 20 mm, at other loads; "
      "give both the same movement, loads and shares in y, or hold it by one of them only");
}

// A path of a support whose loads and shares do not belong together.
TEST_F(BadInput, PathOfASupport) {
  const std::string move = parameter("move by", "Array(double)", "{0, 20, 0}");
  const auto path = [&](const std::string& loads, const std::string& shares) {
    write_scene("strip", {{move, move + parameter("loads", "Array(double)", loads) +
                                     parameter("shares", "Array(double)", shares)}});
  };
  const std::string where = "scene > Supports > upper clamp: parameter ";
  path("{0, 0.5, 1}", "{0, 1}");
  expect_refused(where +
                 "\"shares\" = {0, 1}: found 2 values, but \"loads\" has 3; there must be one share for each "
                 "load");
  path("{0.5}", "{1}");
  expect_refused(where + "\"loads\" = {0.5}: found a single load; a path needs two or more");
  path("{0, 1, 1}", "{0, 0, 1}");
  expect_refused(where + "\"loads\" = {0, 1, 1}: must increase strictly, but value number 3 does not");
}

// A support that holds nothing.
TEST_F(BadInput, SupportOfNothing) {
  write_scene("strip", {{"{strip.bottom}", "{}"}});
  expect_refused("scene > Supports > lower clamp: parameter \"on\" = {}: names no edge and no panel");
}

// A support that moves what it does not hold.
TEST_F(BadInput, MoveOfAFreeDirection) {
  write_scene("strip", {{parameter("hold", "string", "xyz"), parameter("hold", "string", "xz")}});
  expect_refused(
      "scene > Supports > upper clamp: parameter \"move by\" = {0, 20, 0}: moves in y, but \"hold\" is \"xz\"");
}

// A stage that releases a support that the scene does not have.
TEST_F(BadInput, ReleaseOfAnUnknownSupport) {
  write_scene("strip", {{"value=\"load\"/>", "value=\"load\"/>" + parameter("release", "Array(string)", "{plan}")}});
  expect_refused(
      "scene > Stages > pull: parameter \"release\" = {\"plan\"}: no support is named \"plan\"; did you mean "
      "\"plane\"?");
}

// A force curve of a support that the scene does not have.
TEST_F(BadInput, CurveOfAnUnknownSupport) {
  write_scene("strip", {{parameter("support", "string", "upper clamp"), parameter("support", "string", "uper clamp")}});
  expect_refused(
      "scene > Output > Force curves > wale: parameter \"support\" = \"uper clamp\": no support is named "
      "\"uper clamp\"; did you mean \"upper clamp\"?");
}

// A check whose bounds exclude each other.
TEST_F(BadInput, CheckThatCannotHold) {
  write_scene("sleeve", {{parameter("upper", "double", "1e-6"),
                          parameter("lower", "double", "2") + parameter("upper", "double", "1")}});
  expect_refused("scene > Checks > equilibrium: parameter \"lower\" = 2: must not be above \"upper\"");
}

// A folder of results that cannot be made is refused before anything is solved.
TEST_F(BadInput, OutputThatCannotBeWritten) {
  write_scene("strip");
  write("occupied", "a file");
  const Outcome run = toile("run scene.xml --output occupied");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, StartsWith("toile: cannot make the folder of the results \"occupied\": "));
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(read("occupied"), "a file");
}

/// A list "Loads" with one load on the strip, before the stages.
std::pair<std::string, std::string> with_load(const std::string& parameters) {
  const std::string stages = "<ParameterList name=\"Stages\">";
  return {stages, "<ParameterList name=\"Loads\"><ParameterList name=\"pull\">" + parameters +
                      "</ParameterList></ParameterList>" + stages};
}

// A load on a set that does not exist.
TEST_F(BadInput, LoadOnAMissingSet) {
  write_scene("strip", {with_load(parameter("on", "string", "strip.topp") +
                                  parameter("traction", "Array(double)", "{0, 1, 0}"))});
  expect_refused(
      "scene > Loads > pull: parameter \"on\" = \"strip.topp\": no edge or panel is named \"strip.topp\"; did "
      "you mean \"strip.top\"?");
}

// A load per length on a single node.
TEST_F(BadInput, TractionOnANode) {
  write_scene("strip", {with_load(parameter("on", "string", "strip.top-left") +
                                  parameter("traction", "Array(double)", "{0, 1, 0}"))});
  expect_refused("\"strip.top-left\" is a single node; a load per length needs an edge");
}

// A moment or a clamp of the direction on a membrane.
TEST_F(BadInput, MomentOnAMembrane) {
  write_scene("strip", {with_load(parameter("type", "string", "edge moment") + parameter("on", "string", "strip.top") +
                                  parameter("moment", "Array(double)", "{1, 0, 0}"))});
  expect_refused("a moment turns shells only; give the panel a list \"Shell\"");
}
TEST_F(BadInput, DirectorOfAMembrane) {
  const std::string hold = parameter("hold", "string", "z");
  write_scene("strip", {{hold, hold + parameter("director", "string", "held")}});
  expect_refused("scene > Supports > plane: parameter \"director\" = \"held\": is for shells");
}

// A diaphragm whose plane is not given, or lies in the panel.
TEST_F(BadInput, DiaphragmWithoutItsPlane) {
  const std::string hold = parameter("hold", "string", "z");
  write_scene("strip", {{hold, hold + parameter("director", "string", "diaphragm")}});
  expect_refused(
      "scene > Supports > plane: parameter \"director\" = \"diaphragm\": \"diaphragm\" needs the two held directions "
      "of its plane (xy, xz, yz or across direction), but \"hold\" is \"z\"");
}
TEST_F(BadInput, DiaphragmInThePlaneOfThePanel) {
  const std::string along = parameter("elements along", "int", "10");
  write_scene("strip", {{parameter("hold", "string", "z"),
                         parameter("hold", "string", "xy") + parameter("director", "string", "diaphragm")},
                        {along, along + "<ParameterList name=\"Shell\"/>"}});
  expect_refused("\"diaphragm\" needs a panel that passes through its plane, but this one lies in it");
}

// A tension field in a shell, which would wrinkle twice.
TEST_F(BadInput, TensionFieldInAShell) {
  const std::string set = parameter("set", "string", "pantyhose"), material = parameter("material", "string", "fabric");
  write_scene("strip", {{set, set + parameter("compression", "string", "tension field")},
                        {material, material + "<ParameterList name=\"Shell\"/>"}});
  expect_refused(
      "scene > Panels > strip: parameter \"material\" = \"fabric\": the fabric is a tension field (\"compression\" of "
      "\"fabric\"), in which fine wrinkles take up all compression: for membranes.");
}

// Arc length continuation follows undamped equilibria.
TEST_F(BadInput, ArcLengthWithDamping) {
  const std::string type = parameter("type", "string", "load");
  write_scene("strip",
              {{type, type + parameter("continuation", "string", "arc length") + "<ParameterList name=\"Damping\"/>"}});
  expect_refused("must be \"natural\" in a stage with a list \"Damping\"");
}

// A fabric without thickness.
TEST_F(BadInput, ThicknessZero) {
  const std::string set = parameter("set", "string", "pantyhose");
  write_scene("strip", {{set, set + parameter("thickness", "double", "0")}});
  expect_refused("scene > Materials > fabric: parameter \"thickness\" is out of range: 0 mm, allowed: > 0 mm");
}

}  // namespace
}  // namespace toile::test
