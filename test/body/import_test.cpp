#include "toile/body/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <iomanip>
#include <random>
#include <sstream>

#include "body/meshes.hpp"
#include "toile/base/error.hpp"
#include "toile/body/analytic.hpp"

namespace toile::body {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// For the bodies of these tests, which are smaller than a person's limb.
ImportOptions small() {
  ImportOptions options;
  options.least_height = 50.0;
  options.up_is_known = true;
  return options;
}

/// Message of the InputError that importing `file` throws; empty if it does not.
std::string message(const std::string& file, const ImportOptions& options = small()) {
  try {
    import_body(file, options);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TriangleMesh ball() {
  return ellipsoid(60.0, 60.0)->triangles(15.0);
}

/// A ball and its copy, moved by `shift`.
TriangleMesh twins(const Vec3& shift) {
  const TriangleMesh one = ball();
  TriangleMesh two = one;
  const int n = static_cast<int>(one.vertices.size());
  for (const Vec3& v : one.vertices) two.vertices.push_back(v + shift);
  for (const auto& t : one.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return two;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return sum;
}

std::string write_text(const std::string& name, const std::string& text) {
  std::string path = testing::TempDir() + "toile-import-" + name;
  std::ofstream(path) << text;
  return path;
}

/// A block of 100 x 100 x 100 mm as text of the four formats; the OBJ has quads.
const std::string block_obj =
    "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 0 0 100\nv 100 0 100\nv 100 100 100\nv 0 100 100\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
const std::vector<std::array<int, 4>> block_quads{{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
const std::vector<std::string> block_points{"0 0 0",   "100 0 0",   "100 100 0",   "0 100 0",
                                            "0 0 100", "100 0 100", "100 100 100", "0 100 100"};

std::string block_off() {
  std::string text = "OFF\n8 6 0\n";
  for (const auto& p : block_points) text += p + "\n";
  for (const auto& q : block_quads) {
    text += "4";
    for (const int i : q) text += " " + std::to_string(i);
    text += "\n";
  }
  return text;
}

std::string block_ply() {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
  return text + block_off().substr(block_off().find("0 0 0\n"));
}

std::string block_stl() {
  std::string text = "solid block\n";
  for (const auto& q : block_quads) {
    for (const auto& t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (const int i : t) text += "vertex " + block_points[i] + "\n";
      text += "endloop\nendfacet\n";
    }
  }
  return text + "endsolid block\n";
}

// OBJ, OFF, PLY and STL are read, quads are cut into triangles, and the block is closed and looks outwards.
TEST(Import, ReadsAllFormats) {
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"block.obj", block_obj},
                                   {"block.off", block_off()},
                                   {"block.ply", block_ply()},
                                   {"block.stl", block_stl()}}) {
    SCOPED_TRACE(name);
    const Import import = import_body(write_text(name, text), small());
    EXPECT_EQ(import.mesh.vertices.size(), 8u);
    EXPECT_EQ(import.mesh.triangles.size(), 12u);
    EXPECT_NEAR(volume(import.mesh), 1e6, 1e-3);
    EXPECT_EQ(import.notes, "");
  }
}

// A missing file, a folder and an unknown extension are each named.
TEST(Import, UnreadableFiles) {
  EXPECT_EQ(message("/no/where.obj"), "/no/where.obj: there is no such body file");
  EXPECT_EQ(message("/tmp"), "/tmp: is not a file that can hold a body");
  const std::string odd = write_text("body.txt", "hello");
  EXPECT_EQ(message(odd), odd + ": a body file must end in .obj, .stl, .ply or .off, found '.txt'");
}

// More than two facets at an edge: the message counts the edges and says where the first is.
TEST(Import, NotManifold) {
  const std::string file = write_text("fin.obj", block_obj + "v 50 -50 50\nf 1 2 9\n");
  EXPECT_EQ(message(file), file +
                               ": not manifold, more than two facets meet: 1 edges; the first runs from (0, 0, 0) to "
                               "(100, 0, 0). Each edge must belong to two facets.");
}

// A hole is an error that says where it is, unless open ends are allowed.
TEST(Import, Open) {
  const std::string file = write_text("open.obj", block_obj.substr(0, block_obj.rfind("f 4 1 5 8")));
  EXPECT_EQ(message(file),
            file +
                ": the surface is open, it has a border: 4 edges; the first runs from (0, 0, 0) to (0, "
                "100, 0). Close it, or set parameter \"closed\" = false if a tube with open ends is meant.");
  ImportOptions options = small();
  options.closed = false;
  EXPECT_EQ(message(file, options), "");
}

// A body whose facets look inwards is refused, and turned when the user asks for it.
TEST(Import, InsideOut) {
  TriangleMesh mesh = ball();
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  const std::string file = test::write_obj("inside-out", mesh);
  EXPECT_EQ(message(file), file +
                               ": the body is reversed (inside-out): the facets of 1 of 1 connected pieces look "
                               "inwards. Parameter \"repair orientation\" = true turns them.");
  ImportOptions options = small();
  options.repair_orientation = true;
  const Import import = import_body(file, options);
  EXPECT_NEAR(volume(import.mesh), volume(ball()), 1e-3);
  EXPECT_EQ(import.notes, "orientation repaired");
}

// A reversed tube with open ends is recognised too.
TEST(Import, InsideOutTube) {
  TriangleMesh mesh = test::random_triangulation(test::elliptic_tube(80.0, 50.0, 60.0), 10.0, 1);
  ImportOptions options = small();
  options.closed = false;
  EXPECT_EQ(message(test::write_obj("open-tube", mesh), options), "");
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_THAT(message(test::write_obj("open-tube", mesh), options), HasSubstr("the body is reversed (inside-out)"));
}

// One facet turned against its neighbours is refused with its place, and turned when the user asks for it.
TEST(Import, InconsistentFacets) {
  TriangleMesh mesh = ball();
  std::swap(mesh.triangles[40][0], mesh.triangles[40][1]);
  const std::string file = test::write_obj("one-turned", mesh);
  EXPECT_THAT(message(file), HasSubstr("neighbouring facets look to opposite sides: 3 edges; the first runs from ("));
  EXPECT_THAT(message(file), HasSubstr("Parameter \"repair orientation\" = true turns them."));
  ImportOptions options = small();
  options.repair_orientation = true;
  EXPECT_NEAR(volume(import_body(file, options).mesh), volume(ball()), 1e-3);
}

/// The ball stretched to these extents.
TriangleMesh figure(const Vec3& extents) {
  TriangleMesh mesh = ball();
  Eigen::AlignedBox3d box;
  for (const Vec3& v : mesh.vertices) box.extend(v);
  for (Vec3& v : mesh.vertices) v = v.cwiseProduct(extents.cwiseQuotient(box.sizes()));
  return mesh;
}

// A body whose height cannot be one is refused with all three extents and every unit that makes an allowed height of
// it, never with one alone; the right scale mends it.
TEST(Import, WrongUnitListsAllThatFit) {
  const TriangleMesh mesh = figure({600.0, 600.0, 1700.0});
  const std::string metres = test::write_obj("metres", mesh, 1e-3);
  EXPECT_THAT(message(metres, {}), AllOf(HasSubstr(metres + ": the body is 1.7 mm high (z); allowed is 300 to 3000 mm. "
                                                            "Its extents in x, y, z are 0.6 x 0.6 x 1.7 mm. "),
                                         HasSubstr("feet with z up (182.9 x 182.9 x 518.2 mm): \"scale\" = 304.8; "
                                                   "m with z up (600 x 600 x 1700 mm): \"scale\" = 1000: "),
                                         HasSubstr("\"height range\"")));
  ImportOptions options;
  options.scale = 1000.0;
  EXPECT_NEAR(volume(import_body(metres, options).mesh) / volume(mesh), 1.0, 1e-12);
  EXPECT_THAT(message(test::write_obj("inches", mesh, 1.0 / 25.4), {}),
              AllOf(HasSubstr("cm with z up (236.2 x 236.2 x 669.3 mm): \"scale\" = 10; "),
                    HasSubstr("inches with z up (600 x 600 x 1700 mm): \"scale\" = 25.4")));
  options.scale = 1e4;
  EXPECT_THAT(message(metres, options),
              AllOf(HasSubstr("6000 x 6000 x 1.7e+04 mm after \"scale\" and \"up\""), HasSubstr("\"scale\" = 1000:")));
  EXPECT_THAT(message(test::write_obj("huge", mesh, 1e6), {}), HasSubstr("No usual unit makes a body of it. "));
}

// A body with y up is not taken for a low one; with "up" it is turned, not mirrored, and its height is along z.
TEST(Import, YUp) {
  const TriangleMesh lying = figure({400.0, 1700.0, 320.0});
  const std::string file = test::write_obj("y-up", lying);
  EXPECT_THAT(message(file, {}), AllOf(HasSubstr("it seems to lie, for y is the longest"),
                                       HasSubstr("mm with y up (400 x 320 x 1700 mm): \"scale\" = 1, \"up\" = \"y\"")));
  ImportOptions options;
  options.up_is_known = true;
  EXPECT_EQ(message(file, options), "") << "a low body that its user knows of";
  options.up = Axis::y;
  const Import turned = import_body(file, options);
  EXPECT_NEAR(turned.extents.z(), 1700.0, 1e-9);
  EXPECT_NEAR(turned.extents.y(), 320.0, 1e-9);
  EXPECT_NEAR(volume(turned.mesh) / volume(lying), 1.0, 1e-12);
  options.up = Axis::x;
  options.greatest_height = 3000.0;
  const Import other = import_body(file, options);
  EXPECT_NEAR(other.extents.z(), 400.0, 1e-9);
  EXPECT_NEAR(volume(other.mesh) / volume(lying), 1.0, 1e-12);
}

// A body of 200 mm, as for a sleeve on a forearm, is accepted when the range of heights says so, and only then.
TEST(Import, SmallBodyNeedsItsRange) {
  const std::string file = test::write_obj("forearm", ellipsoid(40.0, 100.0)->triangles(10.0));
  EXPECT_THAT(message(file, {}), HasSubstr("\"height range\" what is allowed"));
  ImportOptions options;
  options.least_height = 150.0;
  EXPECT_EQ(message(file, options), "");
}

// Facets without area are removed and reported; two bodies through each other are accepted with a warning.
TEST(Import, DegenerateAndIntersectingFacets) {
  const std::string flat = write_text("flat.obj", block_obj + "v 50 0 0\nf 1 1 2\n");
  EXPECT_EQ(import_body(flat, small()).notes, "1 degenerate or repeated facets removed");
  std::string sliver = block_obj + "v 50 0 0\nf 1 2 9\n";
  sliver.replace(sliver.find("f 1 2 6 5"), 9, "f 1 9 2 6 5");
  const Import closed = import_body(write_text("sliver.obj", sliver), small());
  EXPECT_EQ(closed.notes, "1 facets without area removed");
  EXPECT_NEAR(volume(closed.mesh), 1e6, 1e-3);
  const TriangleMesh two = twins(Vec3(50.0, 3.0, 1.0));
  EXPECT_THAT(import_body(test::write_obj("two", two), small()).notes,
              testing::ContainsRegex("warning: [0-9]+ pairs of facets intersect"));
}

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
  return write_text(name, text.str() + "endsolid ball\n");
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

/// Cylinder as a CAD program exports it: vertices on the rims alone.
TriangleMesh cad_tube(int segments, double radius, double height) {
  TriangleMesh mesh;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2.0 * M_PI * i / segments;
    const int a = 2 * i, b = 2 * ((i + 1) % segments);
    for (const double z : {0.0, height}) mesh.vertices.emplace_back(radius * cos(angle), radius * sin(angle), z);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    sum += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
  }
  return sum;
}

// Triangles as long as the body get vertices all along it, without a gap and on the same surface; a mesh whose
// triangles are about as wide as long stays as it is.
TEST(SplitLongTriangles, LeavesVerticesAllAlong) {
  const TriangleMesh before = cad_tube(72, 60.0, 400.0);
  TriangleMesh mesh = before;
  split_long_triangles(&mesh);
  EXPECT_NEAR(area(mesh) / area(before), 1.0, 1e-12);
  ImportOptions options;
  options.closed = false;
  EXPECT_EQ(import_body(test::write_obj("cad", mesh), options).notes, "") << "still one surface without gaps";
  std::vector<double> heights;
  for (const Vec3& v : mesh.vertices) {
    if (std::hypot(v.x() - 60.0, v.y()) < 1e-9) heights.push_back(v.z());
  }
  std::sort(heights.begin(), heights.end());
  for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_LT(heights[i] - heights[i - 1], 4.0 * 5.24);
  TriangleMesh regular = test::random_triangulation(test::elliptic_tube(80.0, 50.0, 160.0), 20.0, 1);
  const std::size_t facets = regular.triangles.size();
  split_long_triangles(&regular);
  EXPECT_EQ(regular.triangles.size(), facets);
}

// Only triangles in the box stay; with a seed only the piece nearest to it.
TEST(Clip, KeepsTheWantedPiece) {
  const TriangleMesh one = ball();
  const TriangleMesh two = twins(Vec3(150.0, 0.0, 0.0));
  Region region;
  EXPECT_EQ(clip(two, region).triangles.size(), two.triangles.size());
  region.seed = Vec3(140.0, 10.0, 0.0);
  const TriangleMesh right = clip(two, region);
  EXPECT_EQ(right.triangles.size(), one.triangles.size());
  EXPECT_EQ(right.vertices.size(), one.vertices.size());
  for (const Vec3& v : right.vertices) EXPECT_GT(v.x(), 80.0);
  region.lower.z() = 20.0;
  region.upper.z() = 40.0;
  const TriangleMesh band = clip(two, region);
  EXPECT_LT(band.triangles.size(), one.triangles.size() / 2);
  EXPECT_GT(band.triangles.size(), 0u);
  region.lower.z() = 200.0;
  region.upper.z() = 300.0;
  EXPECT_TRUE(clip(two, region).triangles.empty());
}

/// Two tubes side by side, from z = 0 to 200, joined by facets above them that share vertices at z = 210 and 250.
TriangleMesh trousers() {
  const TriangleMesh leg = test::random_triangulation(test::elliptic_tube(40.0, 40.0, 200.0), 20.0, 1);
  TriangleMesh mesh;
  std::vector<int> tops;
  for (const double side : {-1.0, 1.0}) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& v : leg.vertices) mesh.vertices.push_back(v + Vec3(60.0 * side, 0.0, 0.0));
    for (const auto& t : leg.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    tops.push_back(first + static_cast<int>(leg.vertices.size()) - 1);
  }
  const int crotch = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, 210.0);
  mesh.vertices.emplace_back(0.0, 0.0, 250.0);
  for (const int top : tops) {
    mesh.triangles.push_back({top, top - 1, crotch});
    mesh.triangles.push_back({top, crotch, crotch + 1});
  }
  return mesh;
}

// Pieces that are joined outside of the bounds only are different pieces, and the margin continues the wanted one
// outside without coming back down the other.
TEST(Clip, MarginContinuesOnePieceOnly) {
  const TriangleMesh mesh = trousers();
  Region region;
  region.bottom = 50.0;
  region.top = 190.0;
  region.seed = Vec3(60.0, 0.0, 120.0);
  const auto extent = [&mesh](const Region& r) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : clip(mesh, r).vertices) box.extend(v);
    return box;
  };
  EXPECT_GT(extent(region).min().x(), 0.0);
  EXPECT_GT(extent(region).min().z(), 10.0);
  region.margin = 30.0;
  EXPECT_EQ(extent(region).max().z(), 250.0);
  for (const Vec3& v : clip(mesh, region).vertices) {
    EXPECT_TRUE(v.x() >= 0.0 || v.z() > 170.0) << v.transpose();
  }
}

// Heights count along the direction of the region, whichever way it points.
TEST(Clip, FollowsATiltedDirection) {
  Region region;
  region.direction = Vec3(0.6, 0.0, 0.8);
  region.bottom = 20.0;
  region.top = 30.0;
  const TriangleMesh mesh = ball(), part = clip(mesh, region);
  EXPECT_GT(part.triangles.size(), 0u);
  EXPECT_LT(part.triangles.size(), mesh.triangles.size() / 2);
  for (const Vec3& v : part.vertices) EXPECT_NEAR(v.dot(region.direction), 25.0, 25.0);
}

}  // namespace
}  // namespace toile::body
