#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "lists.hpp"
#include "toile/body/analytic.hpp"

namespace toile::scene::test {
namespace {

using ::testing::HasSubstr;

/// The tube of `tube_scene` round a file: two ellipsoids, 600 mm high, 200 mm apart.
ParameterList two_legs() {
  const body::TriangleMesh leg = body::ellipsoid(60.0, 300.0)->triangles(20.0);
  const std::string path = testing::TempDir() + "toile-two-legs.obj";
  std::ofstream out(path);
  for (const double shift : {0.0, 200.0})
    for (const auto& v : leg.vertices) out << "v " << v.x() + shift << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const size_t first : {size_t(1), leg.vertices.size() + 1})
    for (const auto& t : leg.triangles) {
      out << 'f';
      for (const int corner : t) out << ' ' << first + static_cast<size_t>(corner);
      out << '\n';
    }
  ParameterList scene = tube_scene();
  scene.remove("Body");
  scene.sublist("Body").set("type", std::string("file")).set("file", path);
  return scene;
}

// Without a list Reach the body is the piece round the panels' axis at their heights, and the summary says so.
TEST(Reach, FollowsThePanels) {
  const auto scene = build(two_legs());
  const body::TriangleMesh part = scene->surface()->triangles(1.0);
  double bottom = 0.0, top = 0.0;
  for (const auto& v : part.vertices) {
    EXPECT_LT(v.x(), 100.0);
    bottom = std::min(bottom, v.z());
    top = std::max(top, v.z());
  }
  EXPECT_GT(bottom, -100.0);
  EXPECT_LT(top, 220.0);
  EXPECT_GT(top, 150.0);
  EXPECT_THAT(scene->surface()->summary(), HasSubstr("triangles in reach of the panels"));
}

// A support that is moved takes the reach with it.
TEST(Reach, GrowsWithTheSupportsMovement) {
  ParameterList list = two_legs();
  const auto still = build(list);
  list.sublist("Supports").sublist("bottom").set("move by", reals({0, 0, -80}));
  const auto moved = build(list);
  EXPECT_GT(moved->surface()->triangles(1.0).triangles.size(), still->surface()->triangles(1.0).triangles.size());
}

// A support that turns about the panels' axis leaves the reach as it is; about another one it may get anywhere.
TEST(Reach, IsUnknownWhereASupportTurnsOutOfIt) {
  ParameterList list = two_legs();
  ParameterList& bottom = list.sublist("Supports").sublist("bottom");
  bottom.set("hold", std::string("xyz")).set("turn by", 20.0);
  EXPECT_THAT(build(list)->surface()->summary(), HasSubstr("triangles in reach of the panels"));
  bottom.set("axis direction", reals({1, 0, 0}));
  EXPECT_THAT(build(list)->surface()->summary(), testing::Not(HasSubstr("in reach of the panels")));
}

// A list Reach goes before what the panels say.
TEST(Reach, IsTakenFromTheListIfThereIsOne) {
  ParameterList list = two_legs();
  list.sublist("Body").sublist("Reach").set("bottom", -1000.0);
  const auto scene = build(list);
  EXPECT_THAT(scene->surface()->summary(), HasSubstr("triangles in reach (list Reach)"));
  double right = 0.0;
  for (const auto& v : scene->surface()->triangles(1.0).vertices) right = std::max(right, v.x());
  EXPECT_GT(right, 200.0);
}

}  // namespace
}  // namespace toile::scene::test
