// Pieces of bodies: inside others, beside others, in crumbs, and copies of vertices that belong together.
#include <gmock/gmock.h>

#include <algorithm>
#include <iomanip>
#include <random>
#include <sstream>

#include "body/import_support.hpp"
#include "body/meshes.hpp"

namespace toile::body {
namespace {

using test::ball;
using test::message;
using test::small;
using test::twins;
using test::volume;
using testing::AllOf;
using testing::HasSubstr;

/// The ball and inside it its copy of half the size, which looks inwards or outwards.
TriangleMesh hollow(bool inwards) {
  TriangleMesh mesh = twins(Vec3::Zero());
  const std::size_t n = mesh.vertices.size() / 2, m = mesh.triangles.size() / 2;
  for (std::size_t i = n; i < 2 * n; ++i) mesh.vertices[i] *= 0.5;
  for (std::size_t t = m; t < 2 * m && inwards; ++t) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  return mesh;
}

// A closed piece inside another is left out and told, whichever way it looks, and never turned to the outside.
TEST(Import, NestedPiecesAreLeftOut) {
  for (const bool repair : {false, true}) {
    ImportOptions options = small();
    options.repair_orientation = repair;
    const Import cavity = import_body(test::write_obj("hollow", hollow(true)), options);
    EXPECT_NEAR(volume(cavity.mesh), volume(ball()), 1e-3);
    EXPECT_EQ(cavity.notes, "pieces inside another left out: 1 (of them cavities, whose facets look inwards: 1)");
    const Import solid = import_body(test::write_obj("filled", hollow(false)), options);
    EXPECT_NEAR(volume(solid.mesh), volume(ball()), 1e-3);
    EXPECT_EQ(solid.notes, "pieces inside another left out: 1 (of them cavities, whose facets look inwards: 0)");
  }
}

// Of two tubes with open ends, one in the other, the outer one is the body; beside each other both are.
TEST(Import, NestedTubes) {
  const TriangleMesh outer = test::random_triangulation(test::elliptic_tube(80.0, 60.0, 160.0), 10.0, 1);
  ImportOptions options = small();
  options.closed = false;
  for (const bool inside : {true, false}) {
    TriangleMesh mesh = outer;
    const int n = static_cast<int>(outer.vertices.size());
    for (const Vec3& v : outer.vertices) {
      mesh.vertices.push_back(inside ? v.cwiseProduct(Vec3(0.8, 0.8, 1.0)) : Vec3(v + Vec3(170.0, 0.0, 0.0)));
    }
    for (const auto& t : outer.triangles) {
      mesh.triangles.push_back(inside ? std::array{t[1] + n, t[0] + n, t[2] + n}
                                      : std::array{t[0] + n, t[1] + n, t[2] + n});
    }
    const Import import = import_body(test::write_obj("two-tubes", mesh), options);
    EXPECT_EQ(import.mesh.triangles.size(), outer.triangles.size() * (inside ? 1 : 2));
    EXPECT_EQ(import.notes,
              inside ? "pieces inside another left out: 1 (of them cavities, whose facets look inwards: 1)" : "");
  }
}

// Two pieces through each other are refused, with their extents, the number of pairs of facets and the way out.
TEST(Import, PiecesThroughEachOther) {
  const TriangleMesh two = twins(Vec3(50.0, 3.0, 1.0));
  EXPECT_THAT(
      message(test::write_obj("two", two)),
      AllOf(HasSubstr("2 of the 2 connected pieces intersect or touch each other: piece 1 ("),
            testing::ContainsRegex(
                "piece 2 \\([0-9]+ triangles, x -9.563 to 109.6, y -56.13 to 62.13, z -59 to 61 mm\\)"),
            testing::ContainsRegex("[1-9][0-9]+ pairs of facets of different pieces intersect, one of them near \\("),
            HasSubstr("Join the pieces into one closed surface")));
}

// Where only one of two pieces through each other can be reached, they are a warning.
TEST(Import, PiecesThroughEachOtherOutOfReach) {
  ImportOptions options = small();
  options.reach.upper.x() = -20.0;
  EXPECT_THAT(import_body(test::write_obj("two", twins(Vec3(50.0, 3.0, 1.0))), options).notes,
              testing::ContainsRegex("warning: [0-9]+ pairs of facets intersect"));
}

// Pieces that touch with one corner from outside are two pieces; from inside they are refused.
TEST(Import, PiecesThatShareOneCorner) {
  const TriangleMesh one = ball();
  const auto lowest = std::min_element(one.vertices.begin(), one.vertices.end(),
                                       [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  TriangleMesh outside = twins(Vec3::Zero()), inside = outside;
  for (std::size_t i = one.vertices.size(); i < outside.vertices.size(); ++i) {
    outside.vertices[i] = *lowest - (one.vertices[i - one.vertices.size()] - *lowest);
    inside.vertices[i] = *lowest + 0.5 * (one.vertices[i - one.vertices.size()] - *lowest);
  }
  for (std::size_t t = one.triangles.size(); t < outside.triangles.size(); ++t) {
    std::swap(outside.triangles[t][0], outside.triangles[t][1]);  // mirrored
  }
  EXPECT_NEAR(volume(import_body(test::write_obj("outside", outside), small()).mesh), 2.0 * volume(one), 1e-3);
  EXPECT_THAT(message(test::write_obj("inside", inside)), HasSubstr("2 of the 2 connected pieces intersect or touch"));
}

// Pieces inside another one may intersect each other: none of them is the skin.
TEST(Import, PiecesThroughEachOtherInsideAnother) {
  TriangleMesh mesh = ball();
  const TriangleMesh bones = twins(Vec3(50.0, 3.0, 1.0));
  const int n = static_cast<int>(mesh.vertices.size());
  for (const Vec3& v : bones.vertices) mesh.vertices.push_back(0.3 * v);
  for (const auto& t : bones.triangles) mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  const Import import = import_body(test::write_obj("bones", mesh), small());
  EXPECT_NEAR(volume(import.mesh), volume(ball()), 1e-3);
  EXPECT_THAT(import.notes, HasSubstr("pieces inside another left out: 2"));
}

// A body that falls into thousands of pieces is read without comparing each of them with each other.
TEST(Import, ManyPieces) {
  TriangleMesh mesh = ball();
  for (int n = 0; n < 20000; ++n) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& corner : {Vec3::Zero().eval(), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)}) {
      mesh.vertices.push_back(corner + Vec3(70.0 + n % 100, 2.0 * (n / 100 % 50), n / 5000));
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  ImportOptions options = small();
  options.closed = false;
  EXPECT_EQ(import_body(test::write_obj("crumbs", mesh), options).mesh.triangles.size(), mesh.triangles.size());
}

/// Writes the ball as text STL, each copy of a vertex moved by up to `shift`.
std::string write_rounded_stl(const std::string& name, double shift) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(-shift, shift);
  std::ostringstream text;
  text << std::setprecision(17) << "solid ball\n";
  const TriangleMesh mesh = ball();
  for (const auto& t : mesh.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int i : t) {
      const Vec3 v = mesh.vertices[i] + Vec3(part(random), part(random), part(random));
      text << "vertex " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
    }
    text << "endloop\nendfacet\n";
  }
  return test::write_text(name, text.str() + "endsolid ball\n");
}

// Copies of one vertex that differ in the last digits are welded and told; copies further apart are named together with
// the parameter that welds them.
TEST(Import, NearCopiesAreWelded) {
  const std::size_t facets = ball().triangles.size();
  const Import close = import_body(write_rounded_stl("close.stl", 2e-6), small());
  EXPECT_EQ(close.mesh.triangles.size(), facets);
  EXPECT_EQ(close.mesh.vertices.size(), ball().vertices.size());
  EXPECT_THAT(close.notes, HasSubstr(" vertices welded that were up to "));
  const std::string file = write_rounded_stl("far.stl", 0.02);
  EXPECT_THAT(message(file), AllOf(HasSubstr("the surface is open, it has a border"),
                                   HasSubstr("vertices on borders nearly coincide with another one (up to 0.0"),
                                   HasSubstr("Parameter \"weld\" = 0.0")));
  ImportOptions options = small();
  options.weld = 0.08;
  EXPECT_EQ(import_body(file, options).mesh.vertices.size(), ball().vertices.size());
}

}  // namespace
}  // namespace toile::body
