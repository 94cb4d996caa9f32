#include <array>

#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Facets = std::vector<std::array<int, 3>>;

/// A box of 100 x 100 x 400 mm about the z axis, its facets looking outwards.
const Facets box = {{1, 3, 2}, {1, 4, 3}, {5, 6, 7}, {5, 7, 8}, {1, 2, 6}, {1, 6, 5},
                    {2, 3, 7}, {2, 7, 6}, {3, 4, 8}, {3, 8, 7}, {4, 1, 5}, {4, 5, 8}};

std::string obj(const Facets& facets, double scale = 1.0) {
  std::string text;
  for (const double z : {0.0, 400.0})
    for (const auto& [x, y] : {std::pair(-50.0, -50.0), {50.0, -50.0}, {50.0, 50.0}, {-50.0, 50.0}}) {
      text += "v";
      for (const double value : {x, y, z}) text += " " + std::to_string(scale * value);
      text += "\n";
    }
  for (const auto& [a, b, c] : facets)
    text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  return text;
}

/// A body file that cannot be used: exit status 2, and a message that names the file.
class BadBody : public ProgramTest {
 protected:
  void expect_refused(const std::string& body, const std::string& message) const {
    write_scene("sleeve", {{"value=\"cylinder\"", "value=\"file\""},
                           {"name=\"radius\" type=\"double\" value=\"60\"",
                            "name=\"file\" type=\"string\" value=\"bodies/box.obj\""}});
    if (!body.empty()) write("bodies/box.obj", body);
    for (const char* command : {"check", "run"}) {
      const Outcome outcome = toile(std::string(command) + " scene.xml");
      EXPECT_EQ(outcome.status, 2);
      EXPECT_EQ(outcome.out, "");
      EXPECT_THAT(outcome.err, AllOf(StartsWith("toile: "), HasSubstr("bodies/box.obj: "), HasSubstr(message)));
    }
    EXPECT_FALSE(exists("results"));
  }
};

// A body file that is not there.
TEST_F(BadBody, MissingFile) {
  expect_refused("", "there is no such body file");
}

// A file that holds no surface.
TEST_F(BadBody, DamagedFile) {
  expect_refused("this is not a body\n", "bodies/box.obj: line 1: the keyword 'this' is not known in an OBJ file");
}

// Three facets that meet in one edge.
TEST_F(BadBody, NotManifold) {
  Facets facets = box;
  facets.push_back({1, 2, 7});
  expect_refused(obj(facets), "not manifold, more than two facets meet: 2 edges; the first runs from ");
}

// A body whose facets look inwards.
TEST_F(BadBody, InsideOut) {
  Facets facets = box;
  for (auto& facet : facets) std::swap(facet[1], facet[2]);
  expect_refused(obj(facets), "the body is reversed (inside-out)");
  EXPECT_THAT(toile("check scene.xml").err, HasSubstr("repair orientation"));
}

// Facets of which one looks inwards.
TEST_F(BadBody, InconsistentFacets) {
  Facets facets = box;
  std::swap(facets[0][1], facets[0][2]);
  expect_refused(obj(facets), "neighbouring facets look to opposite sides");
}

// A body with a hole.
TEST_F(BadBody, Open) {
  Facets facets = box;
  facets.pop_back();
  expect_refused(obj(facets), "the surface is open, it has a border: 3 edges; the first runs from ");
}

// A body in metres.
TEST_F(BadBody, WrongUnit) {
  expect_refused(
      obj(box, 5e-3),
      "the body is 2 mm high (z); allowed is 300 to 3000 mm. Its extents in x, y, z are 0.5 x 0.5 x 2 mm. The "
      "file may be in feet with z up (152.4 x 152.4 x 609.6 mm): \"scale\" = 304.8; m with z up (500 x 500 x "
      "2000 mm): \"scale\" = 1000: you have to know which.");
}

}  // namespace
}  // namespace toile::test
