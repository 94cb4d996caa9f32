#include <gmock/gmock.h>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using ::testing::HasSubstr;

ParameterList with_load(const std::string& type, const std::string& on, const std::string& value) {
  ParameterList list = flat_scene();
  list.sublist("Loads").sublist("pull").set("type", type).set("on", on).set(value, reals({0, 0, 1}));
  return list;
}

// A load per length acts on an edge: the nodes of a whole panel have no length.
TEST(Loads, PerLengthOnAPanelIsRefused) {
  EXPECT_THAT(
      input_error(with_load("edge", "tube", "traction")),
      HasSubstr("scene > Loads > pull: parameter \"on\" = \"tube\": \"tube\" is a panel; a load per length needs "
                "an edge of it, as tube.top"));
}

// A force acts on one node: on each node of an edge the total would depend on the mesh.
TEST(Loads, ForceOnManyNodesIsRefused) {
  EXPECT_THAT(input_error(with_load("point", "tube.top", "force")), HasSubstr("and each would get the force"));
  EXPECT_NO_THROW(build(with_load("point", "tube.top-right", "force")));
}

// The weight of a panel counts once.
TEST(Loads, WeightOfAPanelNamedTwiceIsRefused) {
  ParameterList list = flat_scene();
  list.sublist("Loads")
      .sublist("weight")
      .set("type", std::string("weight"))
      .set("on", Teuchos::Array<std::string>(2, "tube"))
      .set("area density", 150.0);
  EXPECT_THAT(input_error(list), HasSubstr("names panel \"tube\" twice"));
}

// A load on a part of an edge has the part's length, wherever the nodes lie.
TEST(Loads, OnAPartOfAnEdgeHaveItsLength) {
  const double width = 200.0;  // of the panel's top
  for (const auto& [from, to] : {std::pair(0.13, 0.47), {0.1, 0.33}, {0.0, 1.0}}) {
    const std::string on = "tube.top[" + std::to_string(from) + ":" + std::to_string(to) + "]";
    const std::unique_ptr<Scene> scene = build(with_load("edge", on, "traction"));
    double sum = 0.0;
    for (const double share : scene->problem().loads.front().share) sum += share;
    EXPECT_NEAR(sum, (to - from) * width, 1e-6 * width) << on;
  }
}

}  // namespace
}  // namespace toile::scene::test
