#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "body/meshes.hpp"
#include "toile/base/error.hpp"
#include "toile/body/body.hpp"
#include "toile/body/triangle_tree.hpp"

namespace toile::body {
namespace {

using testing::HasSubstr;

/// The surface of a list "Body" with the given parameters, through an XML file in the folder for temporary files.
SurfacePtr from_xml(const std::string& parameters, const Region* region = nullptr) {
  const std::string path = testing::TempDir() + "toile-body-scene.xml";
  std::ofstream(path) << "<ParameterList name=\"Body\">" << parameters << "</ParameterList>";
  return make_surface(base::read_xml(path, body_spec()), region);
}

std::string text(const std::string& name, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"string\" value=\"" + value + "\"/>";
}
std::string real(const std::string& name, double value) {
  return "<Parameter name=\"" + name + "\" type=\"double\" value=\"" + std::to_string(value) + "\"/>";
}
std::string reals(const std::string& name, const std::string& values) {
  return "<Parameter name=\"" + name + "\" type=\"Array(double)\" value=\"" + values + "\"/>";
}
std::string flag(const std::string& name, bool value) {
  return "<Parameter name=\"" + name + "\" type=\"bool\" value=\"" + (value ? "true" : "false") + "\"/>";
}

/// For a file with a tube of 160 mm, open at its ends.
const std::string small_tube = flag("closed", false) + reals("height range", "{100, 200}");

std::string message(const std::string& parameters) {
  try {
    from_xml(parameters);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

// Every type of body can be asked for in a scene and has its surface where its parameters say.
TEST(MakeSurface, BuildsEveryType) {
  const auto gap = [](const std::string& parameters, double x, double y, double z) {
    return from_xml(parameters)->closest({x, y, z}).gap;
  };
  EXPECT_NEAR(gap(text("type", "leg"), 340.0 / (2.0 * M_PI), 0.0, 334.0), 0.0, 1e-12);
  EXPECT_NEAR(gap(text("type", "cylinder") + real("radius", 50), 60.0, 0.0, 7.0), 10.0, 1e-12);
  EXPECT_NEAR(gap(text("type", "elliptic cylinder") + real("a", 80) + real("b", 50), 0.0, 50.0, 7.0), 0.0, 1e-12);
  EXPECT_NEAR(gap(text("type", "cone") + real("radius", 50) + real("slope", 0.1), 60.0, 0.0, 100.0), 0.0, 1e-12);
  EXPECT_NEAR(gap(text("type", "ellipsoid") + real("radius", 50) + real("half height", 90), 0.0, 0.0, 91.0), 1.0,
              1e-12);
  EXPECT_NEAR(gap(text("type", "sphere") + real("radius", 50), 0.0, 0.0, 60.0), 10.0, 1e-12);
  EXPECT_NEAR(
      gap(text("type", "cosine") + real("radius", 50) + real("amplitude", 5) + real("period", 120), 45.0, 0.0, 60.0),
      0.0, 1e-12);
  EXPECT_NEAR(gap(text("type", "profile") + reals("levels", "{0, 100, 200}") + reals("radii", "{50, 40, 60}"), 0.0,
                  40.0, 100.0),
              0.0, 1e-12);
}

// A file is found beside the scene, is clipped to what the garment can reach, and its summary tells about the fit.
TEST(MakeSurface, BuildsFromFile) {
  const auto mesh = test::random_triangulation(test::elliptic_tube(80.0, 50.0, 160.0), 10.0, 1);
  test::write_obj("tube", mesh);
  const std::string list = text("type", "file") + text("file", "toile-body-tube.obj") + small_tube;
  const SurfacePtr whole = from_xml(list);
  EXPECT_NEAR(whole->closest({0.0, 55.0, 80.0}).gap, 5.0, 0.01);
  Region region;
  region.lower.z() = 60.0;
  region.upper.z() = 100.0;
  const SurfacePtr part = from_xml(list, &region);
  EXPECT_NEAR(part->closest({0.0, 55.0, 80.0}).gap, 5.0, 0.02);
  EXPECT_LT(part->triangles(1.0).triangles.size(), whole->triangles(1.0).triangles.size() / 2);
  EXPECT_THAT(part->summary(), HasSubstr("toile-body-tube.obj: "));
  EXPECT_THAT(part->summary(), HasSubstr("mm root mean square"));
  EXPECT_THAT(part->summary(), HasSubstr("160 x 100 x 160 mm, "));
}

// Bare facets, on which nothing converges, are refused with the reason.
TEST(MakeSurface, BareFacetsAreRefused) {
  EXPECT_THAT(message(text("type", "file") + text("file", "any.obj") + text("surface", "facets")),
              HasSubstr("parameter \"surface\" = \"facets\": bare facets are refused: without friction"));
}

// A cell that would need more memory than a machine has is refused with the number of cells and the way out.
TEST(MakeSurface, TooFineACellIsRefused) {
  test::write_obj("tube", test::random_triangulation(test::elliptic_tube(80.0, 50.0, 160.0), 20.0, 1));
  EXPECT_THAT(message(text("type", "file") + text("file", "toile-body-tube.obj") + small_tube + real("cell", 0.01)),
              testing::AllOf(HasSubstr("parameter \"cell\" = 0.01: "), HasSubstr("would need a grid of "),
                             HasSubstr("enlarge \"cell\"")));
}

// The list's own Reach goes before the garment's region, and a seed picks one of several pieces.
TEST(MakeSurface, ReachIsReadFromTheList) {
  const auto mesh = test::random_triangulation(test::elliptic_tube(80.0, 50.0, 160.0), 10.0, 1);
  test::write_obj("tube", mesh);
  const std::string list = text("type", "file") + text("file", "toile-body-tube.obj") + small_tube;
  const auto part =
      from_xml(list + "<ParameterList name=\"Reach\">" + reals("lower corner", "{0, -100, 40}") +
               reals("upper corner", "{100, 100, 120}") + reals("seed", "{80, 0, 80}") + "</ParameterList>");
  for (const Vec3& vertex : part->triangles(1.0).vertices) {
    EXPECT_GT(vertex.x(), -20.0);
    EXPECT_GT(vertex.z(), 20.0);
  }
  EXPECT_THAT(message(list + "<ParameterList name=\"Reach\">" + real("bottom", 500) + "</ParameterList>"),
              HasSubstr("no triangle of the body lies where the garment can reach; see the list Reach"));
  EXPECT_THAT(message(list + "<ParameterList name=\"Reach\">" + reals("seed", "{80, 0}") + "</ParameterList>"),
              HasSubstr("needs three values x, y, z"));
}

// Parameters that contradict each other are refused with their name.
TEST(MakeSurface, ContradictoryParameters) {
  EXPECT_THAT(message(text("type", "cylinder") + real("radius", 50) + real("bottom", 300)),
              HasSubstr("must be above bottom"));
  EXPECT_THAT(message(text("type", "leg") + real("knee level", 300)), HasSubstr("must be above the level before it"));
  EXPECT_THAT(message(text("type", "cone") + real("radius", 50) + real("slope", -1)),
              HasSubstr("the radius must stay positive"));
  EXPECT_THAT(message(text("type", "cosine") + real("radius", 50) + real("amplitude", 60) + real("period", 9)),
              HasSubstr("must be smaller than the radius"));
  EXPECT_THAT(message(text("type", "profile") + reals("levels", "{0, 0}") + reals("radii", "{50, 40}")),
              HasSubstr("two or more heights in increasing order"));
  EXPECT_THAT(message(text("type", "profile") + reals("levels", "{0, 9}") + reals("radii", "{50}")),
              HasSubstr("needs one radius for each of the 2 levels"));
  EXPECT_THAT(message(text("type", "file") + text("file", "gone.obj")),
              HasSubstr("gone.obj: there is no such body file"));
  EXPECT_THAT(message(text("type", "file") + text("file", "gone.obj") + reals("height range", "{9}")),
              HasSubstr("the least and the greatest height"));
}

// Girths and radii whose smooth curve dips through the axis between its levels, or beyond them where the body is shown,
// are refused with the parameter and the height.
TEST(MakeSurface, SplineThroughTheAxisIsRefused) {
  const std::string dip =
      message(text("type", "profile") + reals("levels", "{0, 100, 110, 210}") + reals("radii", "{5, 5, 60, 60}"));
  EXPECT_THAT(dip, HasSubstr("parameter \"radii\""));
  EXPECT_THAT(dip, HasSubstr("has the radius -"));
  EXPECT_THAT(message(text("type", "leg") + real("knee girth", 5.0) + real("knee level", 600.0)),
              HasSubstr("parameter \"knee girth\" = 5: the smooth curve through these values has the radius -"));
  EXPECT_THAT(message(text("type", "leg") + real("thigh girth", 150.0) + real("top", 2000.0)),
              HasSubstr("parameter \"thigh girth\" = 150: the smooth curve through these values has the radius -"));
}

// The tree's closest facet agrees with a search through all facets, and its barycentric weights give back the point.
TEST(TriangleTree, FindsTheClosestFacet) {
  const TriangleMesh mesh = ellipsoid(60.0, 40.0)->triangles(10.0);
  const TriangleTree tree(mesh);
  const auto exact = ellipsoid(60.0, 40.0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-80.0, 80.0);
  for (int n = 0; n < 300; ++n) {
    const Vec3 x(coordinate(random), coordinate(random), coordinate(random));
    const TriangleTree::Hit hit = tree.closest(x);
    Vec3 point = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(hit.barycentric[i], -1e-9);
      point += hit.barycentric[i] * mesh.vertices[mesh.triangles[hit.triangle][i]];
    }
    EXPECT_LT((point - hit.point).norm(), 1e-9);
    EXPECT_NEAR(hit.distance, (x - point).norm(), 1e-9);
    for (const Vec3& vertex : mesh.vertices) {
      EXPECT_GE((x - vertex).norm(), hit.distance - 1e-9);
    }
    EXPECT_NEAR(hit.signed_distance, exact->closest(x).gap, 1.0);
  }
}

}  // namespace
}  // namespace toile::body
