#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <random>

#include "body/meshes.hpp"
#include "toile/base/error.hpp"
#include "toile/body/import.hpp"

namespace toile::body {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string write_text(const std::string& name, const std::string& text) {
  std::string path = testing::TempDir() + "toile-body-file-" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// A block of 100 x 100 x 100 mm and its facets, looking outwards, corners from 0.
const std::vector<std::array<float, 3>> points{{0, 0, 0},   {100, 0, 0},   {100, 100, 0},   {0, 100, 0},
                                               {0, 0, 100}, {100, 0, 100}, {100, 100, 100}, {0, 100, 100}};
const std::vector<std::array<int, 4>> quads{{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::string coordinates(const std::array<float, 3>& p) {
  return std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]);
}

/// The block as OBJ, with what a dialect writes behind a vertex and for the corner of index i.
std::string obj(const std::string& behind_vertex = "", const std::function<std::string(int)>& corner = {},
                const std::string& between = " ", const std::string& end = "\n") {
  std::string text;
  for (const auto& p : points) text += "v " + coordinates(p) + behind_vertex + end;
  for (const auto& q : quads) {
    text += "f";
    for (const int i : q) text += between + (corner ? corner(i) : std::to_string(i + 1));
    text += end;
  }
  return text;
}

std::string rows() {
  std::string text;
  for (const auto& p : points) text += coordinates(p) + "\n";
  for (const auto& q : quads) {
    text += "4";
    for (const int i : q) text += " " + std::to_string(i);
    text += "\n";
  }
  return text;
}

std::string ply_head(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment a block\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class Number>
std::string bytes(Number value, bool swapped = false) {
  std::string text(sizeof value, '\0');
  std::memcpy(text.data(), &value, sizeof value);
  if (swapped) std::reverse(text.begin(), text.end());
  return text;
}

std::string binary_ply(bool big_endian) {
  std::string text = ply_head(big_endian ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : points)
    for (const float x : p) text += bytes(x, big_endian);
  for (const auto& q : quads) {
    text += '\4';
    for (const int i : q) text += bytes(i, big_endian);
  }
  return text;
}

template <class Facet>
void for_each_triangle(const Facet& facet) {
  for (const auto& q : quads) {
    facet(std::array{q[0], q[1], q[2]});
    facet(std::array{q[0], q[2], q[3]});
  }
}

std::string text_stl() {
  std::string text = "solid block\n";
  for_each_triangle([&text](const std::array<int, 3>& t) {
    text += "  facet normal nan nan nan\n    outer loop\n";
    for (const int i : t) text += "      vertex " + coordinates(points[i]) + "\n";
    text += "    endloop\n  endfacet\n";
  });
  return text + "endsolid block\n";
}

std::string binary_stl() {
  std::string text = "solid in a binary file";
  text.resize(80, ' ');
  text += bytes(static_cast<std::uint32_t>(2 * quads.size()));
  for_each_triangle([&text](const std::array<int, 3>& t) {
    text += std::string(12, '\0');
    for (const int i : t)
      for (const float x : points[i]) text += bytes(x);
    text += std::string(2, '\0');
  });
  return text;
}

ImportOptions small() {
  ImportOptions options;
  options.least_height = 50.0;
  return options;
}

void expect_block(const std::string& name, const std::string& text, const std::string& notes = "") {
  SCOPED_TRACE(name + ":\n" + text.substr(0, 300));
  const Import import = import_body(write_text(name, text), small());
  double volume = 0.0;
  for (const auto& t : import.mesh.triangles) {
    const auto& v = import.mesh.vertices;
    volume += v[t[0]].dot(v[t[1]].cross(v[t[2]])) / 6.0;
  }
  EXPECT_EQ(import.mesh.vertices.size(), 8u);
  EXPECT_EQ(import.mesh.triangles.size(), 12u);
  EXPECT_NEAR(volume, 1e6, 1e-3);
  EXPECT_EQ(import.notes, notes);
}

void expect_refused(const std::string& name, const std::string& text, const std::string& why) {
  const std::string file = write_text(name, text);
  try {
    import_body(file, small());
    ADD_FAILURE() << "accepted: " << why;
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(StartsWith(file + ": "), HasSubstr(why)));
  }
}

// Every dialect of OBJ gives the same block: tabs, other line ends, continued lines, indices that count back, corners
// with texture and normal, colours, weights, comments, groups, materials and a byte order mark.
TEST(BodyFile, DialectsOfObj) {
  const auto from_one = [](int i) { return std::to_string(i + 1); };
  const auto backwards = [](int i) { return std::to_string(i - 8); };
  const auto all_three = [](int i) { return std::to_string(i + 1) + "/1/" + std::to_string(i + 1); };
  const auto no_texture = [](int i) { return std::to_string(i + 1) + "//1"; };
  expect_block("plain.obj", obj());
  expect_block("tabs.obj", obj("\t", from_one, "\t"));
  expect_block("windows.obj", obj("", from_one, " ", "\r\n"));
  expect_block("old-mac.obj", obj("", from_one, " ", "\r"));
  expect_block("continued.obj", obj("", from_one, " \\\n  "));
  expect_block("continued-windows.obj", obj("", from_one, " \\\r\n  ", "\r\n"));
  expect_block("backwards.obj", obj("", backwards));
  expect_block("all-three.obj", "vt 0 0\nvn 0 0 1\n" + obj("", all_three));
  expect_block("no-texture.obj", obj("", no_texture));
  expect_block("coloured.obj", obj(" 0.8 0.6 0.5"));
  expect_block("weighted.obj", obj(" 1.0"));
  expect_block("named.obj",
               "\xEF\xBB\xBF# C:\\bodies\\\nmtllib none.mtl\no block\ng a b\nusemtl skin\ns off\nvp 0.5\n" + obj());
  expect_block("loose.obj", obj() + "l 1 2\np 3\n", "2 loose lines or points left out");
}

// What an OBJ file must not hold is refused with its line and its word.
TEST(BodyFile, BadObj) {
  expect_refused("keyword.obj", obj() + "facet 1 2 3\n", "line 15: the keyword 'facet' is not known in an OBJ file");
  expect_refused("curve.obj", obj() + "\ncurv 0 1 1 2\n", "line 16: the curved surfaces of 'curv' are not read");
  expect_refused("comma.obj", "v 0,5 0 0\n" + obj(), "line 1: '0,5' is not a number");
  expect_refused("nan.obj", "v 0 nan 0\n" + obj(), "line 1: 'nan' is not a finite number");
  expect_refused("huge.obj", "v 1e308 0 50\n" + obj(), "too large for a body in any unit");
  expect_refused("short.obj", "v 0 0\n" + obj(), "line 1: a vertex 'v' needs x y z");
  expect_refused("words.obj", obj() + "f a b c\n", "line 15: 'a' is not a whole number");
  expect_refused("slashes.obj", obj() + "f 1/1/1/1 2 3\n", "line 15: '1/1/1/1' is not a corner of a facet");
  expect_refused("zero.obj", obj() + "f 0 1 2\n", "line 15: the corner '0' is not there");
  expect_refused("before.obj", obj() + "f -9 1 2\n", "line 15: the corner '-9' is not there");
  expect_refused("beyond.obj", obj() + "f 1 2 2147483648\n",
                 "line 15: a facet has the corner 2147483648, but the file has 8 vertices, counted from 1");
  expect_refused("two.obj", obj() + "f 1 2\n", "line 15: a facet needs three corners or more, found 2");
  expect_refused("points.obj", "v 0 0 0\nv 0 0 300\n", "holds no facets (2 vertices)");
  expect_refused("prose.obj", "this is not a body\n", "line 1: the keyword 'this' is not known");
  expect_refused("empty.obj", "", "is empty");
}

// OFF with its numbers beside or below its name, with colours and comments; what it announces must be there, and no
// more.
TEST(BodyFile, Off) {
  expect_block("block.off", "OFF\n# a block\n8 6 12\n\n" + rows());
  expect_block("beside.off", "OFF 8 6 12\n" + rows());
  std::string coloured = rows();
  for (std::size_t i = 0; (i = coloured.find('\n', i)) != std::string::npos; i += 9) coloured.insert(i, " 255 0 0");
  expect_block("coloured.off", "COFF\n8 6 0\n" + coloured);
  expect_refused("name.off", "FOO\n8 6 0\n" + rows(), "line 1: an OFF file begins with OFF");
  expect_refused("binary.off", "OFF BINARY\n" + rows(), "line 1: binary OFF is not read");
  expect_refused("negative.off", "OFF\n8 -6 0\n" + rows(), "line 2: the numbers of vertices and facets must not be");
  expect_refused("facets.off", "OFF\n8 2147483647 0\n" + rows(),
                 "line 16: the file ends after 6 of the 2147483647 facets");
  expect_refused("more.off", "OFF\n8 5 0\n" + rows(), "line 16: the file goes on after the 5 facets");
  for (const std::string corners : {"-3", "2", "4000000000"}) {
    expect_refused("corners.off", "OFF\n8 7 0\n" + rows() + corners + " 0 1 2\n",
                   "line 17: a facet of '" + corners + "' corners is not possible here");
  }
  expect_refused("corner.off", "OFF\n8 7 0\n" + rows() + "3 0 1 8\n",
                 "line 17: a facet has the corner 8, but the file has 8 vertices, counted from 0");
}

// PLY as text and binary of both orders, with other elements beside; a damaged head or row is refused with its place.
TEST(BodyFile, Ply) {
  const std::string text = ply_head("ascii") + rows();
  expect_block("text.ply", text);
  expect_block("little.ply", binary_ply(false));
  expect_block("big.ply", binary_ply(true));
  std::string more = text;
  more.replace(more.find("element face"), 0, "property uchar red\nelement edge 1\nproperty int vertex1\n");
  for (std::size_t row = 0, i = more.find("end_header"); row < 9; ++row) {
    i = more.find('\n', i) + 1;
    if (row > 0) {
      more.insert(i - 1, " 7");
      i += 2;
    }
  }
  more.insert(more.find("4 3 2 1 0"), "1\n");
  expect_block("more.ply", more);

  expect_refused("before.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n",
                 "line 3: a property before any element");
  const auto edited = [&text](const std::string& from, const std::string& to) {
    std::string result = text;
    return result.replace(result.rfind(from), from.size(), to);
  };
  expect_refused("list-x.ply", edited("float x", "list uchar float x"),
                 "the property 'x' of 'vertex' must be a number, not a list");
  expect_refused("scalar.ply", edited("list uchar int", "int"),
                 "the property 'vertex_indices' of 'face' must be a list");
  expect_refused("half.ply", edited("list uchar int", "list float int"), "line 9: the length of a list must be");
  expect_refused("type.ply", edited("float y", "real y"), "line 6: 'real' is not a type of PLY");
  expect_refused("no-end.ply", edited("end_header", "comment"), "line 11: the keyword '0.000000' is not known");
  expect_refused("count.ply", edited("element vertex 8", "element vertex 4000000000"),
                 "line 19: vertex 9 of 4000000000: more values than its properties");
  expect_refused("length.ply", edited("4 3 0 4 7", "2000000000 3 0 4 7"),
                 "face 6 of 6: the list 'vertex_indices' announces 2000000000 values, and 4 follow");
  expect_refused("corner.ply", edited("4 3 0 4 7", "4 3 0 4 77"), "face 6: a facet has the corner 77");
  expect_refused("part.ply", edited("4 3 0 4 7", "4 3 0 4 6.5"), "face 6 of 6: a whole number is due");
  expect_refused("cut.ply", binary_ply(false).substr(0, binary_ply(false).size() - 3), "face 6 of 6: the list");
  expect_refused("nan.ply", edited("100.000000\n", "nan\n"), "'nan' is not a finite number");
}

// STL as text and binary, whatever its head begins with and its normals are; a damaged one is refused with its place.
TEST(BodyFile, Stl) {
  expect_block("text.stl", text_stl());
  expect_block("binary.stl", binary_stl());
  std::string upper = text_stl();
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  expect_block("upper.stl", upper);
  expect_refused("cut-text.stl", text_stl().substr(0, text_stl().find("endsolid")), "the file ends without 'endsolid'");
  expect_refused(
      "cut-binary.stl", binary_stl().substr(0, 400),
      "is neither text nor a whole binary STL: of its 400 bytes, 84 are the head, which announces 12 facets");
  for (const float odd : {NAN, HUGE_VALF}) {
    std::string text = binary_stl();
    text.replace(84 + 50 * 11 + 24, 4, bytes(odd));
    expect_refused("odd.stl", text, "facet 12, corner 2: a vertex has a coordinate that is not a finite number");
  }
  std::string word = text_stl();
  word.replace(word.find("endloop"), 7, "enloop!");
  expect_refused("word.stl", word, "line 7: 'endloop' is due, found 'enloop!'");
}

/// Whether a mutated file is refused with its name, or a surface of finite vertices comes out of it.
void expect_sane(const std::string& name, const std::string& text, const ImportOptions& options) {
  const std::string file = write_text(name, text);
  try {
    for (const Vec3& v : import_body(file, options).mesh.vertices) ASSERT_TRUE(v.allFinite());
  } catch (const base::InputError& error) {
    ASSERT_THAT(error.what(), StartsWith(file + ": "));
  } catch (const std::exception& error) {
    FAIL() << "not an input error: " << error.what() << "\n" << text;
  }
}

// Files that are cut off anywhere, or in which bytes or words are replaced by hostile ones, are refused with their name
// or give a surface: nothing else.
TEST(BodyFile, MutationsAreRefusedOrSurfaces) {
  const std::vector<std::pair<std::string, std::string>> files{{"m.obj", obj(" 1", {}, " \\\n")},
                                                               {"m.off", "OFF\n8 6 0\n" + rows()},
                                                               {"mt.ply", ply_head("ascii") + rows()},
                                                               {"mb.ply", binary_ply(true)},
                                                               {"mt.stl", text_stl()},
                                                               {"mb.stl", binary_stl()}};
  const std::vector<std::string> hostile{"nan",        "-inf", "1e308",
                                         "-1",         "0",    "2147483647",
                                         "4294967296", "",     "99999999999999999999",
                                         "x\n",        "/",    std::string(3, '\0')};
  std::mt19937 random(7);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  ImportOptions open = small();
  open.closed = false;
  open.least_height = 1e-3;
  for (const auto& [name, text] : files) {
    for (int n = 0; n < 60; ++n) {
      const ImportOptions options = n % 2 == 0 ? small() : open;
      expect_sane(name, text.substr(0, below(text.size())), options);
      std::string changed = text;
      changed[below(text.size())] = static_cast<char>(random());
      expect_sane(name, changed, options);
      const std::size_t begin = std::min(text.find_first_of(" \n", below(text.size())), text.size() - 1) + 1;
      const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
      changed = text;
      expect_sane(name, changed.replace(begin, end - begin, hostile[below(hostile.size())]), options);
    }
  }
}

}  // namespace
}  // namespace toile::body
