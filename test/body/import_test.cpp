#include "toile/body/import.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>

#include "body/meshes.hpp"
#include "toile/base/error.hpp"
#include "toile/body/analytic.hpp"

namespace toile::body {
namespace {

using testing::HasSubstr;

/// For the bodies of these tests, which are smaller than a person's limb.
ImportOptions small() {
  ImportOptions options;
  options.least_height = 50.0;
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

// A missing file, an unknown extension and a damaged file are each named.
TEST(Import, UnreadableFiles) {
  EXPECT_EQ(message("/no/where.obj"), "/no/where.obj: there is no such body file");
  const std::string odd = write_text("body.txt", "hello");
  EXPECT_EQ(message(odd), odd + ": a body file must end in .obj, .stl, .ply or .off, found '.txt'");
  const std::string damaged = write_text("damaged.off", "OFF\n3 1 0\n0 0 0\n1 0");
  const std::string why = " (no facets, corners that are not there, or damaged text)";
  EXPECT_EQ(message(damaged), damaged + ": cannot be read as off" + why);
  const std::string missing_corner = write_text("corner.obj", block_obj + "f 1 2 99\n");
  EXPECT_EQ(message(missing_corner), missing_corner + ": cannot be read as obj" + why);
  std::string ply = block_ply();
  ply.replace(ply.rfind("4 3 0 4 7"), 9, "4 3 0 4 77");
  const std::string damaged_ply = write_text("corner.ply", ply);
  EXPECT_EQ(message(damaged_ply), damaged_ply + ": cannot be read as ply" + why);
  const std::string empty = write_text("empty.stl", "");
  EXPECT_EQ(message(empty), empty + ": cannot be read as stl" + why);
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

// A body in metres is recognised, the message names the unit and the parameter, and that parameter mends it.
TEST(Import, WrongUnit) {
  const TriangleMesh mesh = ellipsoid(300.0, 800.0)->triangles(100.0);
  const std::string metres = test::write_obj("metres", mesh, 1e-3);
  EXPECT_EQ(message(metres, {}), metres +
                                     ": the body is 1.6 mm high, allowed is 300 to 3000 mm; it looks like metres: set "
                                     "parameter \"scale\" = 1000, or \"height range\" if the body is that small");
  ImportOptions options;
  options.scale = 1000.0;
  EXPECT_NEAR(volume(import_body(metres, options).mesh) / volume(mesh), 1.0, 1e-12);
  EXPECT_EQ(message(test::write_obj("huge", mesh, 1e3), {}),
            testing::TempDir() +
                "toile-body-huge.obj: the body is 1.6e+06 mm high, allowed is 300 to 3000 mm; z must be the height, "
                "and parameter \"scale\" turns the unit of the file into mm; parameter \"height range\" says what is "
                "allowed");
}

// A person and a leg in centimetres are recognised by default, the message names the scale, and that scale mends them.
TEST(Import, Centimetres) {
  for (const double half_height : {850.0, 400.0}) {
    const std::string file = test::write_obj("centimetres", ellipsoid(100.0, half_height)->triangles(50.0), 0.1);
    EXPECT_THAT(message(file, {}), HasSubstr("allowed is 300 to 3000 mm; it looks like centimetres: set parameter "
                                             "\"scale\" = 10, or \"height range\""));
    ImportOptions options;
    options.scale = 10.0;
    EXPECT_EQ(message(file, options), "");
  }
}

// A body of 200 mm, as for a sleeve on a forearm, is accepted when the range of heights says so, and only then.
TEST(Import, SmallBodyNeedsItsRange) {
  const std::string file = test::write_obj("forearm", ellipsoid(40.0, 100.0)->triangles(10.0));
  EXPECT_THAT(message(file, {}), HasSubstr("\"height range\" if the body is that small"));
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
