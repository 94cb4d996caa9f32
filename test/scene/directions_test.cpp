// Supports along any direction: what is read, and what is refused with which words.
#include <gmock/gmock.h>

#include <cmath>

#include "lists.hpp"

namespace toile::scene::test {
namespace {

using solve::Vec3;
using ::testing::HasSubstr;

ParameterList& support(ParameterList& scene, const std::string& name) {
  return scene.sublist("Supports").sublist(name);
}

/// The scene with a support "hem" of the upper edge.
ParameterList with_hem(ParameterList scene, const std::string& hold) {
  add_support(scene, "hem", "tube.top");
  support(scene, "hem").set("hold", hold);
  return scene;
}

// A direction has any length, and is moved along itself.
TEST(Direction, IsRead) {
  ParameterList scene = with_hem(flat_scene(), "direction");
  support(scene, "hem").set("direction", reals({0, 3, 4})).set("move along", 7.0);
  const auto built = build(scene);
  const solve::Support& hem = built->problem().supports.at(1);
  EXPECT_EQ(hem.held, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(hem.axes.size(), hem.nodes.size());
  EXPECT_LT((hem.axis(0, 0) - Vec3(0, 0.6, 0.8)).norm(), 1e-15);
  EXPECT_LT((hem.axes[0] * hem.axes[0].transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_EQ(hem.displacement, Vec3(7.0, 0.0, 0.0));
}

// The plane across a direction is held and moved in space; the direction of an axis may be left free by supports that
// turn about it.
TEST(Direction, AcrossItIsAPlane) {
  ParameterList scene = with_hem(flat_scene(), "across direction");
  support(scene, "hem").set("direction", reals({0, 3, 4})).set("move by", reals({1, 4, -3}));
  support(scene, "hem").set("turn by", 10.0).set("axis direction", reals({0, 0.6, 0.8}));
  const auto built = build(scene);
  const solve::Support& hem = built->problem().supports.at(1);
  EXPECT_EQ(hem.held, (std::array<bool, 3>{false, true, true}));
  EXPECT_LT((hem.axes[0].transpose() * hem.displacement - Vec3(1, 4, -3)).norm(), 1e-14);
}

// Along the limb is the axis of the wrap in the tangent plane of the body, and round a seam the same for its nodes.
TEST(Direction, AlongTheLimbLiesInTheSurface) {
  ParameterList scene = with_hem(tube_scene(), "along the limb");
  scene.sublist("Body").set("type", std::string("cone")).set("slope", 0.2);
  const auto built = build(scene);
  const solve::Support& hem = built->problem().supports.at(1);
  for (size_t k = 1; k + 1 < hem.nodes.size(); ++k) {
    const Vec3& x = built->garment().mesh.placed[hem.nodes[k]];
    const Vec3 generator = (Vec3(x.x(), x.y(), 0.0).normalized() * 0.2 + Vec3::UnitZ()).normalized();
    EXPECT_LT((hem.axis(k, 0) - generator).norm(), 1e-9) << k;
  }
  EXPECT_LT((hem.axes.front() - hem.axes.back()).norm(), 1e-15);
}

// One node may be held: at a corner, at a place in the panel and nearest to a point of the pattern.
TEST(Direction, NodesMayBeNamedOneByOne) {
  ParameterList scene = flat_scene();
  add_support(scene, "nodes", "tube.top");
  Teuchos::Array<std::string> names;
  for (const char* name : {"tube.top-left", "tube@0.5 0.5", "tube@(101 27)"}) names.push_back(name);
  support(scene, "nodes").set("on", names);
  EXPECT_THAT(build(scene)->problem().supports.at(1).nodes, ::testing::ElementsAre(4 * 13, 2 * 13 + 6, 13 + 6));
  support(scene, "nodes").set("on", Teuchos::Array<std::string>(1, "tube@(10.1 250)"));
  EXPECT_THAT(input_error(scene),
              HasSubstr("\"tube@(10.1 250)\" lies outside of the pattern of panel \"tube\": its nearest node is at ("));
}

// What does not go together is refused.
TEST(Direction, BadOnesAreRefused) {
  const auto message = [](const std::string& hold, const std::function<void(ParameterList&)>& change) {
    ParameterList scene = with_hem(flat_scene(), hold);
    change(support(scene, "hem"));
    return input_error(scene);
  };
  EXPECT_THAT(message("direction", [](ParameterList&) {}),
              HasSubstr("is missing: \"hold\" = \"direction\" needs it (x, y, z)"));
  EXPECT_THAT(message("direction",
                      [](ParameterList& hem) {
                        hem.set("direction", reals({0, 0, 0}));
                      }),
              HasSubstr("must not be zero"));
  EXPECT_THAT(
      message("z",
              [](ParameterList& hem) {
                hem.set("direction", reals({0, 0, 1}));
              }),
      HasSubstr("goes with \"hold\" = \"direction\", \"across direction\" or \"along the limb\", but \"hold\" is "
                "\"z\""));
  EXPECT_THAT(message("direction",
                      [](ParameterList& hem) {
                        hem.set("direction", reals({0, 1, 1})).set("move by", reals({0, 1, 1}));
                      }),
              HasSubstr("\"hold\" = \"direction\" moves by \"move along\""));
  EXPECT_THAT(message("across direction",
                      [](ParameterList& hem) {
                        hem.set("direction", reals({0, 1, 1})).set("move by", reals({0, 1, 0}));
                      }),
              HasSubstr("has a part along \"direction\""));
  EXPECT_THAT(message("along the limb", [](ParameterList&) {}), HasSubstr("the scene has no list \"Body\""));
  EXPECT_THAT(message("direction",
                      [](ParameterList& hem) {
                        hem.set("direction", reals({0, 1, 1})).set("turn by", 5.0);
                      }),
              HasSubstr("which leaves them free across it"));
}

// A limb's direction that stands on the surface, and a panel that is not wrapped, leave along the limb without a
// meaning.
TEST(Direction, AlongTheLimbNeedsATangent) {
  ParameterList scene = with_hem(tube_scene(), "along the limb");
  support(scene, "hem").set("direction", reals({1, 0, 0}));
  EXPECT_THAT(input_error(scene), HasSubstr("the limb's direction stands on the body's surface"));
  ParameterList flat = with_hem(tube_scene(), "along the limb");
  ParameterList& placement = flat.sublist("Panels").sublist("tube").sublist("Placement");
  placement = ParameterList("Placement");
  placement.set("type", std::string("flat")).set("origin", reals({-100, 62, 10}));
  placement.set("y direction", reals({0, 0, 1}));
  flat.remove("Seams");
  EXPECT_THAT(input_error(flat), HasSubstr("the limb's direction is not known"));
}

// Supports of one node along one direction must move alike, and directions that nearly agree are refused, with both
// names.
TEST(Direction, ContradictionsNameBothSupports) {
  ParameterList scene = with_hem(flat_scene(), "direction");
  support(scene, "hem").set("direction", reals({0, 1, 1})).set("move along", 3.0);
  add_support(scene, "other", "tube.top-left");
  support(scene, "other").set("hold", std::string("direction")).set("direction", reals({0, 2, 2}));
  EXPECT_THAT(input_error(scene),
              HasSubstr("scene > Supports > other: parameter \"move along\" = 0 (default): contradicts support "
                        "\"hem\": both hold the node at (0, 100, 0) mm along (0, 0.707107, 0.707107), "
                        "but \"other\" moves it by 0 mm and \"hem\" by 3 mm"));
  support(scene, "other").set("direction", reals({0, 1, 1.01}));
  EXPECT_THAT(input_error(scene), HasSubstr("along nearly the same direction, (0, 0.70"));
}

}  // namespace
}  // namespace toile::scene::test
