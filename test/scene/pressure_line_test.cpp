#include <gmock/gmock.h>

#include <cmath>

#include "scene/lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::HasSubstr;

constexpr double radius = 60.0;  // mm, of the body of tube_scene()

ParameterList scene_with(const std::string& type, const ParameterList& line) {
  ParameterList scene = tube_scene();
  scene.sublist("Output").sublist("Lines").sublist("line").setParameters(line).set("type", type);
  return scene;
}

PressureLine line_of(const ParameterList& scene) {
  return build(scene)->output().lines.front();
}

ParameterList meridian_cut() {
  ParameterList line;
  line.set("at", reals({radius, 0, 50})).set("normal", reals({0, 1, 0})).set("stations", 11);
  return line;
}

// A cut along an open body is one of its two sides, from the end closer to "from" to the other.
TEST(Lines, CutOfAnOpenBodyRunsFromEndToEnd) {
  ParameterList cut = meridian_cut();
  cut.set("from", reals({radius, 0, 1e4}));
  const PressureLine line = line_of(scene_with("cut", cut));
  ASSERT_EQ(line.places.size(), 11u);
  EXPECT_LT(line.places.back().place.z(), line.places.front().place.z());
  for (size_t s = 0; s < 11; ++s) {
    EXPECT_NEAR(line.places[s].place.x(), radius, 1e-9);
    EXPECT_NEAR(line.lengths[s], line.places.front().place.z() - line.places[s].place.z(), 1e-6);
  }
}

// Between two places of an open cut the line runs either way.
TEST(Lines, CutBetweenPlaces) {
  for (const auto& [from, to] : {std::pair(20.0, 90.0), std::pair(90.0, 20.0)}) {
    ParameterList cut = meridian_cut();
    cut.set("at", reals({-radius, 0, from})).set("to", reals({-radius - 30, 5, to}));
    const PressureLine line = line_of(scene_with("cut", cut));
    EXPECT_NEAR(line.lengths.back(), 70.0, 1e-9);
    EXPECT_LT((line.places.front().place - solve::Vec3(-radius, 0, from)).norm(), 1e-9);
    EXPECT_LT((line.places.back().place - solve::Vec3(-radius, 0, to)).norm(), 1e-9);
  }
}

// A closed cut runs counter-clockwise seen against its normal, whichever side that looks to.
TEST(Lines, ClosedCutTurnsAboutItsNormal) {
  for (const double side : {1.0, -1.0}) {
    ParameterList cut;
    cut.set("at", reals({0, radius, 50})).set("normal", reals({0, 0, side})).set("to", reals({radius, 0, 50}));
    const PressureLine line = line_of(scene_with("cut", cut));
    const double quarters = side > 0.0 ? 3.0 : 1.0;  // from y to x
    EXPECT_NEAR(line.lengths.back(), quarters * 0.5 * M_PI * radius, 1e-4 * radius * quarters);
  }
}

// Several lines stand in the order of the scene, each with its own stations and the body's normals.
TEST(Lines, SeveralLines) {
  ParameterList scene = scene_with("cut", meridian_cut());
  ParameterList& level = scene.sublist("Output").sublist("Lines").sublist("another");
  level.set("type", std::string("level")).set("height", 30.0).set("from", reals({900, 0, 0})).set("stations", 5);
  const std::vector<PressureLine> lines = build(scene)->output().lines;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].title, "another");
  ASSERT_EQ(lines[1].places.size(), 5u);
  EXPECT_LT((lines[1].places[1].place - solve::Vec3(0, radius, 30)).norm(), 0.01);
  EXPECT_LT((lines[1].places[1].normal - solve::Vec3::UnitY()).norm(), 1e-3);
}

// Without a body, and with numbers that are out of range, lines are refused.
TEST(Lines, WithoutABodyAreRefused) {
  ParameterList scene = flat_scene();
  scene.sublist("Output")
      .sublist("Lines")
      .sublist("line")
      .setParameters(meridian_cut())
      .set("type", std::string("cut"));
  EXPECT_THAT(input_error(scene),
              HasSubstr("scene > Output > Lines > line: parameter \"type\" = \"cut\": the scene has "
                        "no list \"Body\", so there is no pressure"));
  ParameterList one = meridian_cut();
  one.set("stations", 1);
  EXPECT_THAT(input_error(scene_with("cut", one)),
              HasSubstr("parameter \"stations\" is out of range: 1, allowed: 2 <= value <= 10000"));
}

}  // namespace
}  // namespace toile::scene::test
