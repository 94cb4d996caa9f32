#include <gmock/gmock.h>

#include <cmath>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::HasSubstr;

ParameterList& add_distance(ParameterList& scene, const std::string& first, const std::string& second) {
  return scene.sublist("Output").sublist("Distances").sublist("width").set("first", first).set("second", second);
}

// Levels, force curves, distances and checks are read in the order and with the values of the file.
TEST(Output, IsRead) {
  ParameterList list = tube_scene();
  add_support(list, "top", "tube.top");
  list.sublist("Output").set("stations", 7);
  list.sublist("Output").sublist("Levels").sublist("B").set("height", 20.0);
  list.sublist("Output").sublist("Levels").sublist("C").set("height", 90.0);
  list.sublist("Output")
      .sublist("Force curves")
      .sublist("wale")
      .set("support", std::string("top"))
      .set("length", 100.0);
  add_distance(list, "tube.left", "tube.right").set("first at", 0.0).set("second at", 1.0);
  list.sublist("Checks").sublist("gap").set("quantity", std::string("largest gap")).set("upper", 1e-6);
  const auto scene = build(list);
  const Output& output = scene->output();
  EXPECT_EQ(output.stations, 7);
  ASSERT_EQ(output.levels.size(), 2u);
  EXPECT_EQ(output.levels[1].name, "C");
  EXPECT_EQ(output.levels[1].height, 90.0);
  ASSERT_EQ(output.force_curves.size(), 1u);
  EXPECT_EQ(scene->problem().supports.at(static_cast<size_t>(output.force_curves[0].support)).name, "top");
  ASSERT_EQ(output.distances.size(), 1u);
  const mesh::Mesh& mesh = scene->garment().mesh;
  EXPECT_EQ(output.distances[0].first.first, mesh.edges.at("tube.left").front());
  EXPECT_EQ(output.distances[0].first.share, 0.0);
  EXPECT_EQ(output.distances[0].second.second, mesh.edges.at("tube.right").back());
  EXPECT_EQ(output.distances[0].second.share, 1.0);
  ASSERT_EQ(scene->checks().size(), 1u);
  EXPECT_EQ(scene->checks()[0].upper, 1e-6);
  EXPECT_EQ(scene->checks()[0].lower, -std::numeric_limits<double>::infinity());
}

// The end of a distance on an edge that no panel has.
TEST(Output, UnknownEdgeIsRefused) {
  ParameterList list = flat_scene();
  add_distance(list, "tube.lefft", "tube.right");
  EXPECT_EQ(input_error(list),
            "scene.xml: scene > Output > Distances > width: parameter \"first\" = \"tube.lefft\": no edge is named "
            "\"tube.lefft\"; did you mean \"tube.left\"? Valid here: tube.bottom, tube.left, tube.right, tube.top");
}

// Nodes that move along a limb whose direction changes have no one direction of a force.
TEST(Output, ForceCurveAlongAConicalLimbIsRefused) {
  ParameterList list = tube_scene();
  list.sublist("Body").set("type", std::string("cone")).set("slope", 0.1);
  add_support(list, "hem", "tube.top");
  ParameterList& hem = list.sublist("Supports").sublist("hem");
  hem.set("hold", std::string("along the limb")).set("move along", 3.0);
  list.sublist("Output").sublist("Force curves").sublist("w").set("support", std::string("hem")).set("length", 100.0);
  EXPECT_THAT(input_error(list), HasSubstr("its nodes move in different directions, along the limb"));
}

// A force curve of a support that the scene does not have.
TEST(Output, UnknownSupportIsRefused) {
  ParameterList list = flat_scene();
  list.sublist("Output").sublist("Force curves").sublist("w").set("support", std::string("top")).set("length", 100.0);
  EXPECT_EQ(
      input_error(list),
      "scene.xml: scene > Output > Force curves > w: parameter \"support\" = \"top\": no support is named \"top\". "
      "Valid here: bottom");
}

// An axis without a direction, a curve of one point.
TEST(Output, DegenerateCurvesAreRefused) {
  ParameterList axis = tube_scene();
  axis.sublist("Output").set("axis direction", reals({0, 0, 0}));
  EXPECT_THAT(input_error(axis), HasSubstr("parameter \"axis direction\" = {0, 0, 0}: must not be zero"));
  ParameterList point = tube_scene();
  point.sublist("Output").set("stations", 1);
  EXPECT_THAT(input_error(point),
              HasSubstr("parameter \"stations\" = 1: a curve needs at least 2 points; 0: no curve"));
}

// What needs a pressure needs a body.
TEST(Output, PressureWithoutABodyIsRefused) {
  ParameterList level = flat_scene();
  level.sublist("Output").sublist("Levels").sublist("B").set("height", 20.0);
  EXPECT_THAT(input_error(level), HasSubstr("scene > Output > Levels > B: parameter \"height\" = 20: the scene has no "
                                            "list \"Body\", so there is no pressure"));
  ParameterList check = flat_scene();
  check.sublist("Checks").sublist("p").set("quantity", std::string("largest pressure")).set("upper", 1.0);
  EXPECT_THAT(input_error(check), HasSubstr("scene > Checks > p: parameter \"quantity\" = \"largest pressure\": the "
                                            "scene has no list \"Body\""));
}

ParameterList& add_drapemeter(ParameterList& scene, double disc, double fabric) {
  return scene.sublist("Output").sublist("Drapemeter").set("disc radius", disc).set("fabric radius", fabric);
}

// A drapemeter needs fabric beyond its disc, of the area of the round fabric or of its ring.
TEST(Output, DrapemeterOfAnotherFabricIsRefused) {
  ParameterList small = flat_scene();
  add_drapemeter(small, 90.0, 90.0);
  EXPECT_THAT(input_error(small), HasSubstr("scene > Output > Drapemeter: parameter \"fabric radius\" = 90: must be "
                                            "greater than \"disc radius\""));
  ParameterList other = flat_scene();
  add_drapemeter(other, 40.0, 100.0);
  EXPECT_THAT(input_error(other), HasSubstr("the panels have an area of 20000 mm^2; the whole fabric has 31415.9 mm^2, "
                                            "its ring beyond the disc 26389.4 mm^2"));
  ParameterList rectangle = flat_scene();
  add_drapemeter(rectangle, 60.0, 100.0);  // 20106 mm^2 beyond the disc, which the rectangle has too
  EXPECT_THAT(input_error(rectangle), HasSubstr("mm from the axis of \"Output\" (\"axis point\", \"axis direction\")"));
  const Drapemeter ring{60.0, 100.0};
  EXPECT_DOUBLE_EQ(ring.coefficient(M_PI * 100.0 * 100.0), 1.0);
  EXPECT_NEAR(ring.coefficient(M_PI * 60.0 * 60.0), 0.0, 1e-12);
}

// A check without a bound would hold whatever comes out.
TEST(Output, CheckWithoutABoundIsRefused) {
  ParameterList list = tube_scene();
  list.sublist("Checks").sublist("gap").set("quantity", std::string("largest gap"));
  EXPECT_THAT(input_error(list), HasSubstr("scene > Checks > gap: parameter \"lower\""));
  EXPECT_THAT(input_error(list), HasSubstr("a check without a bound always holds"));
}

// Light falls along a straight axis.
TEST(Output, DrapemeterOnABentAxisIsRefused) {
  ParameterList list = flat_scene();
  add_drapemeter(list, 60.0, 100.0);
  list.sublist("Output").set("axis", reals({0, 0, 0, 0, 0, 50, 0, 20, 100}));
  EXPECT_THAT(input_error(list), HasSubstr("does not go with the list \"Drapemeter\""));
}

// A check of drape needs a drapemeter.
TEST(Output, CheckOfDrapeWithoutADrapemeterIsRefused) {
  ParameterList list = flat_scene();
  list.sublist("Checks").sublist("drape").set("quantity", std::string("drape coefficient")).set("upper", 0.8);
  EXPECT_THAT(input_error(list), HasSubstr("scene > Checks > drape: parameter \"quantity\" = \"drape coefficient\": "
                                           "needs the list \"Output > Drapemeter\""));
}

}  // namespace
}  // namespace toile::scene::test
