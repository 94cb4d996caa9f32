// Supports that turn: what is read, and what is refused with which words.
#include <gmock/gmock.h>

#include <cmath>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::HasSubstr;

/// The flat scene with a support "hub" that turns the upper edge.
ParameterList turning_scene(double degrees = 30.0) {
  ParameterList scene = flat_scene();
  add_support(scene, "hub", "tube.top");
  scene.sublist("Supports").sublist("hub").set("hold", std::string("xyz")).set("turn by", degrees);
  return scene;
}

ParameterList& hub(ParameterList& scene) {
  return scene.sublist("Supports").sublist("hub");
}

ParameterList& make_shell(ParameterList& scene) {
  return scene.sublist("Panels").sublist("tube").sublist("Shell");
}

// Angles are given in degrees, the direction of the axis has any length, and its point is the origin by default.
TEST(TurningSupport, IsRead) {
  ParameterList scene = turning_scene();
  hub(scene).set("axis direction", reals({0, 3, 4}));
  const auto built = build(scene);
  const auto& turn = built->problem().supports.at(1).turn;
  ASSERT_TRUE(turn.has_value());
  EXPECT_DOUBLE_EQ(turn->angle, M_PI / 6.0);
  EXPECT_LT((turn->axis - solve::Vec3(0.0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_EQ(turn->point, solve::Vec3::Zero());
  EXPECT_FALSE(built->problem().supports.at(0).turn.has_value());
  EXPECT_THAT(built->used(), testing::Contains("turning supports"));
}

// The direction along an axis that is one of x, y and z may be left free.
TEST(TurningSupport, MayLeaveTheDirectionOfTheAxisFree) {
  ParameterList scene = turning_scene();
  hub(scene).set("hold", std::string("xy"));
  EXPECT_TRUE(build(scene)->problem().supports.at(1).turn.has_value());
}

// A direction across the axis must not be left free.
TEST(TurningSupport, MustHoldWhatItTurns) {
  ParameterList scene = turning_scene();
  hub(scene).set("hold", std::string("xz"));
  EXPECT_THAT(input_error(scene),
              HasSubstr("scene > Supports > hub: parameter \"turn by\" = 30: turns nodes on circles "
                        "about the axis, but \"hold\" is \"xz\", which leaves them free across it; "
                        "allowed here: \"xyz\" or \"xy\""));
  hub(scene).set("axis direction", reals({0, 1, 1}));
  EXPECT_THAT(input_error(scene), ::testing::EndsWith("allowed here: \"xyz\""));
}

// An axis needs a direction.
TEST(TurningSupport, NeedsADirectionOfItsAxis) {
  ParameterList scene = turning_scene();
  hub(scene).set("axis direction", reals({0, 0, 0}));
  EXPECT_THAT(input_error(scene),
              HasSubstr("scene > Supports > hub: parameter \"axis direction\" = {0, 0, 0}: must not be zero"));
  hub(scene).set("axis direction", reals({0, 1}));
  EXPECT_THAT(input_error(scene), HasSubstr("found 2 numbers, expected 3 (x, y, z)"));
}

// An axis about which nothing turns is a mistake.
TEST(TurningSupport, AxisWithoutATurnIsRefused) {
  ParameterList scene = turning_scene();
  hub(scene).remove("turn by");
  hub(scene).set("axis point", reals({1, 2, 3}));
  EXPECT_THAT(input_error(scene), HasSubstr("scene > Supports > hub: parameter \"axis point\" = {1, 2, 3}: nothing "
                                            "turns: give \"turn by\" as well, or leave this out"));
}

// A plane of symmetry does not turn, nor does a diaphragm.
TEST(TurningSupport, SymmetryIsRefused) {
  ParameterList scene = turning_scene();
  hub(scene).set("director", std::string("symmetry"));
  EXPECT_THAT(input_error(scene), HasSubstr("scene > Supports > hub: parameter \"director\" = \"symmetry\": a plane of "
                                            "symmetry or a diaphragm does not turn"));
}

// Two supports that take one node along different paths contradict each other, even if the paths end at the same place;
// a direction in which the turn moves nothing is no contradiction.
TEST(TurningSupport, ContradictsASupportThatStays) {
  for (const double degrees : {90.0, 360.0}) {
    ParameterList scene = turning_scene(degrees);
    hub(scene).set("axis point", reals({0, 100, 0}));
    EXPECT_NO_THROW(build(scene));
    add_support(scene, "left", "tube.left");
    EXPECT_NO_THROW(build(scene));  // along the axis
    scene.sublist("Supports").sublist("left").set("hold", std::string("y"));
    scene.sublist("Supports").sublist("left").set("on", Teuchos::Array<std::string>(1, "tube.top"));
    EXPECT_THAT(
        input_error(scene),
        testing::AllOf(HasSubstr("scene > Supports > left: parameter \"move by\" = {0, 0, 0} (default): contradicts "
                                 "support \"hub\": both hold the node at ("),
                       HasSubstr(" mm in y, but \"left\" moves it by 0 mm and \"hub\" by "),
                       HasSubstr(" mm (on a circle); give both the same movement in y")));
  }
}

// Two clamps of one node must turn its director alike.
TEST(TurningSupport, ContradictsAClampThatStays) {
  ParameterList scene = turning_scene();
  scene.sublist("Materials").sublist("knit").set("compression", std::string("full"));
  make_shell(scene);
  hub(scene).set("director", std::string("held"));
  EXPECT_NO_THROW(build(scene));
  add_support(scene, "clamp", "tube.top");
  scene.sublist("Supports").sublist("clamp").set("hold", std::string("none")).set("director", std::string("held"));
  EXPECT_THAT(input_error(scene), HasSubstr("scene > Supports > clamp: parameter \"director\" = \"held\": contradicts "
                                            "support \"hub\": both hold directors of the same nodes"));
}

// A force curve is drawn over a movement, which a turn is not.
TEST(TurningSupport, HasNoForceCurve) {
  ParameterList scene = turning_scene();
  ParameterList& curve = scene.sublist("Output").sublist("Force curves").sublist("wale");
  curve.set("support", std::string("hub")).set("length", 100.0);
  EXPECT_THAT(input_error(scene),
              HasSubstr("scene > Output > Force curves > wale: parameter \"support\" = \"hub\": this "
                        "support turns, and its torque is in torques.csv"));
}

}  // namespace
}  // namespace toile::scene::test
