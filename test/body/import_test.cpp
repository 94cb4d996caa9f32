#include "toile/body/import.hpp"

#include <gmock/gmock.h>

#include "body/import_support.hpp"
#include "body/meshes.hpp"

namespace toile::body {
namespace {

using test::ball;
using test::message;
using test::small;
using test::volume;
using test::write_text;
using testing::HasSubstr;

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
  EXPECT_EQ(
      message(file),
      file +
          ": not manifold, more than two facets meet: 1 edges; the first runs from (0, 0, 0) to "
          "(100, 0, 0). Each edge must belong to two facets. Pieces that touch along an edge are to be joined into "
          "one, or moved apart; a wall that is there twice is to be there once.");
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

// Facets without area are removed and reported.
TEST(Import, DegenerateFacets) {
  const std::string flat = write_text("flat.obj", block_obj + "v 50 0 0\nf 1 1 2\n");
  EXPECT_EQ(import_body(flat, small()).notes, "1 degenerate or repeated facets removed");
  std::string sliver = block_obj + "v 50 0 0\nf 1 2 9\n";
  sliver.replace(sliver.find("f 1 2 6 5"), 9, "f 1 9 2 6 5");
  const Import closed = import_body(write_text("sliver.obj", sliver), small());
  EXPECT_EQ(closed.notes, "1 facets without area removed");
  EXPECT_NEAR(volume(closed.mesh), 1e6, 1e-3);
}

}  // namespace
}  // namespace toile::body
