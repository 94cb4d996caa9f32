#include "toile/scene/start_report.hpp"

#include <gmock/gmock.h>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

StartReport look(const ParameterList& list) {
  const base::List valid = base::validate(list, scene_spec(), "scene.xml");
  base::Timer timer;
  const Scene scene(valid, 1, timer);
  return look_at_start(scene, valid, solve::compute_fields(scene.problem(), scene.start()));
}

/// The tube, sewn in a stage.
ParameterList open_tube() {
  ParameterList list = tube_scene();
  add_sewing(list);
  return list;
}

ParameterList& panel_of(ParameterList& list) {
  return list.sublist("Panels").sublist("tube");
}

/// Two halves of a tube, of the panel's width each.
ParameterList halves(const std::string& first, const std::string& second) {
  ParameterList list = open_tube();
  ParameterList& front = panel_of(list);
  front.set("width", 100.0);
  front.sublist("Placement").set("coverage", 0.48);
  list.sublist("Panels").set("back", front);
  list.sublist("Panels").sublist("back").sublist("Placement").set("angle", 180.0);
  list.remove("Seams");
  const std::string side[] = {"left", "right"};
  for (const std::string& name : side) {
    ParameterList& seam = list.sublist("Seams").sublist(name);
    seam.set("first", "tube." + name).set("second", "back." + (name == "left" ? first : second));
  }
  return list;
}

// The report of a usual start has a line for each panel, each seam, what is inside the body, the pressure and the mesh;
// stretches
// are those of the placed panel: 110 mm over 100, 0.9 x 2 pi 60 mm over 200, less by the chords
// of twelve elements, and 2 pi 60 mm over 200 once closed, 1.885.
TEST(StartReport, TellsStretchesAndGaps) {
  const StartReport report = look(open_tube());
  EXPECT_THAT(report.lines,
              ElementsAre("panel \"tube\": stretch 1.1 along the wale, 1.68 along the course; round the body, seams "
                          "closed, 1.88",
                          "seam \"side\": tube.left to tube.right, 37.1 mm apart on average, at most 37.1 (from the "
                          "other end 80.4)",
                          "inside the body: no node", HasSubstr("pressure of the fabric as it is placed"),
                          AllOf(HasSubstr("mesh: "), HasSubstr("quadrilaterals; smallest angle 90 degrees"))));
  EXPECT_THAT(report.warnings, IsEmpty());
  EXPECT_THAT(report.errors, IsEmpty());
}

// A seam that is sewn from its far end makes a Moebius band: refused with the seam, both orders and the parameter.
TEST(StartReport, RefusesASeamThatRunsAgainstItself) {
  ParameterList list = open_tube();
  list.sublist("Seams").sublist("side").set("reversed", true);
  EXPECT_THAT(look(list).errors,
              ElementsAre(AllOf(HasSubstr("scene.xml: scene > Seams > side: parameter \"reversed\" = true: the seam "
                                          "\"side\" runs against itself"),
                                HasSubstr("lie 80.4 mm apart on average"), HasSubstr("from the other end 37.1 mm"),
                                HasSubstr("Moebius"), HasSubstr("Leave \"reversed\" out"))));
}

// A seam that would need "reversed" is refused with that parameter.
TEST(StartReport, AsksForTheOtherOrder) {
  ParameterList list = halves("right", "left");
  ParameterList& band = list.sublist("Panels").sublist("back");
  band.set("height", 50.0);
  band.sublist("Placement").set("angle", 0.0).set("from", 125.0).set("to", 180.0);
  list.remove("Seams");
  // The top of the panel runs from left to right, and so does the bottom of the one above it.
  list.sublist("Seams").sublist("ring").set("first", std::string("tube.top")).set("second", std::string("back.bottom"));
  EXPECT_THAT(look(list).errors, IsEmpty());
  list.sublist("Seams").sublist("ring").set("reversed", true);
  EXPECT_THAT(look(list).errors, ElementsAre(HasSubstr("the seam \"ring\" runs against itself")));
  // Turned upside down, its own top is below.
  list.sublist("Seams").sublist("ring").set("second", std::string("back.top"));
  ParameterList& flat = band.sublist("Placement");
  flat = ParameterList();
  flat.set("type", std::string("flat")).set("origin", reals({60.0, 40.0, 180.0}));
  flat.set("x direction", reals({0, -1, 0})).set("y direction", reals({0, 0, -1}));
  EXPECT_THAT(look(list).errors, IsEmpty());
  list.sublist("Seams").sublist("ring").set("reversed", false);
  EXPECT_THAT(look(list).errors, ElementsAre(HasSubstr("Give the seam \"reversed\" = true")));
}

// A Moebius band of two panels whose edges run alike is found by the sides of the fabric that its seams join.
TEST(StartReport, RefusesAMoebiusBandOfPanels) {
  ParameterList list = flat_scene();
  list.sublist("Panels").set("next", panel_of(list));
  ParameterList& placement = list.sublist("Panels").sublist("next").sublist("Placement");
  placement.set("type", std::string("flat")).set("origin", reals({230, 0, 0}));
  list.sublist("Seams").sublist("side").set("first", std::string("tube.right")).set("second", std::string("next.left"));
  EXPECT_THAT(look(list).errors, IsEmpty());
  list.sublist("Seams").sublist("tops").set("first", std::string("tube.top")).set("second", std::string("next.top"));
  EXPECT_THAT(look(list).errors, ElementsAre(HasSubstr("the seam \"tops\" makes a Moebius band")));
}

// Seams between sides that face each other are fine; seams through the body are refused with the nearer edge.
TEST(StartReport, RefusesASeamThroughTheBody) {
  EXPECT_THAT(look(halves("right", "left")).errors, IsEmpty());
  EXPECT_THAT(look(halves("right", "left")).warnings, IsEmpty());
  const StartReport wrong = look(halves("left", "right"));
  EXPECT_THAT(wrong.errors,
              ElementsAre(AllOf(HasSubstr("Seams > left: parameter \"second\" = \"back.left\": the way from tube.left "
                                          "to back.left leads through the body (60 mm deep, gap 120 mm)"),
                                HasSubstr("back.right is much nearer to tube.left (7.53 mm)")),
                          HasSubstr("Seams > right")));
}

// A seam over a wide opening goes through the body without a better edge: a warning that asks for more coverage.
TEST(StartReport, WarnsOfAWideOpening) {
  ParameterList list = open_tube();
  panel_of(list).sublist("Placement").set("coverage", 0.6);
  EXPECT_THAT(look(list).warnings, ElementsAre(AllOf(HasSubstr("seam \"side\": the way from tube.left to tube.right "
                                                               "leads through the body"),
                                                     HasSubstr("more \"coverage\""))));
}

// A pattern in centimetres: 11 times along the wale; the warning names the unit and what it would be in mm.
TEST(StartReport, WarnsOfCentimetres) {
  ParameterList list = open_tube();
  panel_of(list).set("width", 20.0).set("height", 10.0);
  EXPECT_THAT(look(list).warnings,
              ElementsAre(AllOf(HasSubstr("panel \"tube\" starts stretched to 11 along the wale and 16.8 along the "
                                          "course"),
                                HasSubstr("as if the pattern were in centimetres"),
                                HasSubstr("10 times larger, it would be stretched to 1.1 and 1.68"))));
}

// A modulus in kPa gives a pressure that no garment has.
TEST(StartReport, WarnsOfKilopascals) {
  ParameterList list = open_tube();
  list.sublist("Materials").sublist("knit") = ParameterList();
  ParameterList& knit = list.sublist("Materials").sublist("knit");
  knit.set("type", std::string("neo-hookean")).set("C10", 50.0).set("thickness", 0.5);
  EXPECT_THAT(look(list).warnings,
              ElementsAre(AllOf(HasSubstr("panel \"tube\" would press with about"), HasSubstr("a modulus in kPa?"))));
  knit.set("C10", 0.05);
  EXPECT_THAT(look(list).warnings, IsEmpty());
}

// A garment that is wider than its body all round is loose: 377 mm round the body over a pattern of 400.
TEST(StartReport, WarnsOfAGarmentWiderThanItsBody) {
  ParameterList list = open_tube();
  panel_of(list).set("width", 400.0);
  EXPECT_THAT(look(list).warnings, ElementsAre(AllOf(HasSubstr("the garment is wider than its body"),
                                                     HasSubstr("\"tube\" is stretched to 0.94"))));
  panel_of(list).set("width", 370.0);
  EXPECT_THAT(look(list).warnings, IsEmpty());
}

// A panel that starts deep in the body is told with its depth and place.
TEST(StartReport, WarnsOfAPanelInsideTheBody) {
  ParameterList list = flat_scene();
  list.sublist("Body").set("type", std::string("cylinder")).set("radius", 60.0);
  ParameterList& placement = panel_of(list).sublist("Placement");
  placement.set("type", std::string("flat")).set("origin", reals({20, -100, 0}));
  placement.set("x direction", reals({0, 1, 0})).set("y direction", reals({0, 0, 1}));
  const StartReport report = look(list);
  EXPECT_THAT(report.lines, ::testing::Contains("inside the body: at most 40 mm, at (20, 0, 0) mm of panel \"tube\""));
  EXPECT_THAT(report.warnings, ElementsAre(HasSubstr("panel \"tube\" starts 40 mm inside the body")));
}

// A part without support and away from the body is named.
TEST(StartReport, WarnsOfAPartThatNothingHolds) {
  ParameterList list = flat_scene();
  list.remove("Supports");
  EXPECT_THAT(look(list).warnings, ElementsAre("nothing holds \"tube\": no support and no body"));
  list.sublist("Body").set("type", std::string("cylinder")).set("radius", 60.0);
  ParameterList& placement = panel_of(list).sublist("Placement");
  placement.set("type", std::string("flat")).set("origin", reals({80, -100, 0}));
  placement.set("x direction", reals({0, 1, 0})).set("y direction", reals({0, 0, 1}));
  EXPECT_THAT(look(list).warnings,
              ElementsAre("nothing holds \"tube\": no support, and it starts 20 mm or more from the body"));
}

// Sides that face each other on the body and are not sewn are told.
TEST(StartReport, WarnsOfAForgottenSeam) {
  ParameterList list = halves("right", "left");
  list.sublist("Seams").remove("right");
  EXPECT_THAT(look(list).warnings,
              ElementsAre(HasSubstr("back.left and tube.right face each other on the body, 7.53 mm "
                                    "apart, and are not sewn: is a seam forgotten?")));
}

// A support on a part of an edge that ends between nodes is told with the way to the nearest; one that ends at nodes is
// not.
TEST(StartReport, WarnsOfAPartThatEndsBetweenNodes) {
  ParameterList list = flat_scene();
  const auto warnings = [&](const std::string& on) {
    list.sublist("Supports").sublist("part").set("on", Teuchos::Array<std::string>(1, on)).set("hold", "xyz");
    return look(list).warnings;
  };
  EXPECT_THAT(warnings("tube.top[0.3:0.77]"),
              ::testing::Contains(AllOf(HasSubstr("support \"part\": tube.top[0.3:0.77] ends between nodes, "),
                                        HasSubstr(" mm from the nearest, which is taken"))));
  EXPECT_THAT(warnings("tube.top[0.25:0.75]"), ::testing::Not(::testing::Contains(HasSubstr("between nodes"))));
}

// Levels count along the output's axis: the same garment, moved with its axis, has the same ones.
TEST(StartReport, LevelsCountAlongTheAxis) {
  ParameterList list = tube_scene();
  ParameterList& output = list.sublist("Output");
  output.set("axis point", reals({0, 0, -10000})).set("axis direction", reals({0, 0, 1}));
  const auto warnings = [&](double height) {
    output.sublist("Levels").sublist("middle").set("height", height);
    return look(list).warnings;
  };
  EXPECT_THAT(warnings(10050.0), IsEmpty());
  EXPECT_THAT(warnings(50.0), ElementsAre(HasSubstr("level \"middle\" is at a height of 50 mm")));
}

// A garment that reaches beyond the levels of its body is told from where to where the body is given.
TEST(StartReport, WarnsOfABodyThatIsNotGivenThere) {
  ParameterList list = tube_scene();
  list.remove("Body");
  ParameterList& body = list.sublist("Body");
  body.set("type", std::string("profile")).set("radii", reals({60, 60}));
  body.set("levels", reals({0, 60}));
  EXPECT_THAT(look(list).warnings,
              ElementsAre(HasSubstr("the body is given from z = 0 to 60 mm, and the garment starts "
                                    "between 10 and 120 mm")));
  body.set("levels", reals({0, 120}));
  EXPECT_THAT(look(list).warnings, IsEmpty());
}

}  // namespace
}  // namespace toile::scene::test
