// Names that a scene does not have are told before its body is read, which takes the longest.
#include <gmock/gmock.h>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A scene with the level "calf", the points "front" and "knee" and the support "bottom", on a body that is not there.
ParameterList scene_without_its_body() {
  ParameterList scene = tube_scene();
  scene.remove("Body");
  scene.sublist("Body").set("type", std::string("file")).set("file", std::string("missing.obj"));
  ParameterList& output = scene.sublist("Output");
  output.sublist("Levels").sublist("calf").set("height", 60.0);
  output.sublist("Points").sublist("front").set("on", std::string("tube@0.5,0.5"));
  output.sublist("Body points").sublist("knee").set("at", reals({60, 0, 60}));
  return scene;
}

Teuchos::Array<std::string> texts(const std::vector<std::string>& all) {
  return Teuchos::Array<std::string>(all);
}

void expect_refused(const ParameterList& scene, const std::string& where, const std::string& what) {
  EXPECT_THAT(input_error(scene), AllOf(HasSubstr("scene.xml: scene > " + where), HasSubstr(what)));
}

ParameterList with_check(const std::string& quantity) {
  ParameterList scene = scene_without_its_body();
  scene.sublist("Checks").sublist("one").set("quantity", quantity).set("upper", 1.0);
  return scene;
}

// With names that are there the missing body is what is told.
TEST(Names, BodyIsReadAfterThem) {
  ParameterList scene = with_check("pressure at level calf");
  scene.sublist("Accuracy").set("error", 1.0).set("at", texts({"calf", "front", "knee"}));
  EXPECT_THAT(input_error(scene), HasSubstr("missing.obj: there is no such body file"));
}

// Levels and supports of testers, and supports of force curves.
TEST(Names, OfOutput) {
  ParameterList level = scene_without_its_body();
  ParameterList& sensor = level.sublist("Output").sublist("Testers").sublist("one");
  sensor.set("type", std::string("rigid sensor")).set("level", std::string("claf"));
  sensor.set("width", 20.0).set("height", 1.0);
  expect_refused(level, "Output > Testers > one: parameter \"level\"",
                 "no level is named \"claf\"; did you mean \"calf\"?");
  ParameterList jaw = scene_without_its_body();
  ParameterList& jaws = jaw.sublist("Output").sublist("Testers").sublist("one");
  jaws.set("type", std::string("flat jaws")).set("support", std::string("botom")).set("width", 50.0);
  jaws.set("girth", 200.0);
  expect_refused(jaw, "Output > Testers > one: parameter \"support\"", "did you mean \"bottom\"?");
  ParameterList curve = scene_without_its_body();
  ParameterList& force = curve.sublist("Output").sublist("Force curves").sublist("one");
  force.set("support", std::string("botom")).set("length", 100.0);
  expect_refused(curve, "Output > Force curves > one: parameter \"support\"",
                 "no support is named \"botom\"; did you mean \"bottom\"?");
}

// Quantities of checks, their levels and their classes.
TEST(Names, OfChecks) {
  const std::string where = "Checks > one: parameter \"quantity\"";
  expect_refused(with_check("largest presure"), where, "did you mean \"largest pressure\"?");
  expect_refused(with_check("pressure at level claf"), where, "no level is named \"claf\"; did you mean \"calf\"?");
  expect_refused(with_check("ratio of levels calf to claf"), where, "did you mean \"calf\"?");
  expect_refused(with_check("drape coefficient"), where, "needs the list \"Output > Drapemeter\"");
  ParameterList scene = with_check("compression class at level calf");
  scene.sublist("Checks").sublist("one").remove("upper");
  scene.sublist("Checks").sublist("one").set("class", std::string("V"));
  expect_refused(scene, "Checks > one: parameter \"class\"", "no class of RAL-GZ 387 is named \"V\"");
}

// Places at which an accuracy is asked for.
TEST(Names, OfAccuracy) {
  ParameterList scene = scene_without_its_body();
  scene.sublist("Accuracy").set("error", 1.0).set("at", texts({"calf", "kneee"}));
  expect_refused(scene, "Accuracy: parameter \"at\"",
                 "no level, point or body point is named \"kneee\"; did you mean \"knee\"? Valid here: calf, front, "
                 "knee");
}

// Supports that a stage releases, what is loaded, and seams that a stage sews.
TEST(Names, OfStagesAndLoads) {
  ParameterList release = scene_without_its_body();
  release.sublist("Stages").sublist("settle").set("release", texts({"botom"}));
  expect_refused(release, "Stages > settle: parameter \"release\"",
                 "no support is named \"botom\"; did you mean \"bottom\"? Valid here: bottom");
  release.remove("Supports");
  expect_refused(release, "Stages > settle: parameter \"release\"",
                 "no support is named \"botom\". The scene has no supports");
  ParameterList load = scene_without_its_body();
  load.sublist("Loads").sublist("pull").set("on", std::string("tube.topp")).set("traction", reals({0, 0, 1}));
  expect_refused(load, "Loads > pull: parameter \"on\"", "did you mean \"tube.top\"?");
  ParameterList sew = scene_without_its_body();
  add_sewing(sew);
  sew.remove("Seams");
  expect_refused(sew, "Stages > sew: parameter \"type\"", "the scene has no list \"Seams\"");
}

}  // namespace
}  // namespace toile::scene::test
