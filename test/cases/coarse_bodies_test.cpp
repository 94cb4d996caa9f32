// Bodies of few facets, and bodies in a unit that they were not made in: right, warned of or refused.
#include <cmath>

#include "cases/sleeve_on_body.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

double no_shift() {
  return 0.0;
}

// A cylinder and a cone of 24 and of 8 strips, with vertices on their rims alone, have the pressure of the round body;
// it is the same all round.
TEST_F(Bodies, FewStrips) {
  for (const auto& [around, slope] : {std::pair(24, 0.0), {8, 0.0}, {24, 0.05}}) {
    write("body.stl", stl(tube(60.0, 1, 400.0, around, slope), no_shift));
    write_sleeve({{"body.obj", "body.stl"}});
    SCOPED_TRACE(around);
    const std::string out = expect_pressure(pressure_of(250.0), mesh_error);
    EXPECT_THAT(out, Not(HasSubstr("flat")));
    std::istringstream row(read("results/pressure-levels.csv"));
    std::string word;
    std::getline(row, word);
    for (int column = 0; column < 5; ++column) std::getline(row, word, ',');
    EXPECT_NEAR(std::strtod(word.c_str(), nullptr) / pressure_of(250.0), 1.0, mesh_error) << "smallest of the level";
  }
}

// Strips whose upper rim is turned by half a step against the lower one have chords for edges: what they do to the body
// is told with its size.
TEST_F(Bodies, TurnedStripsAreTold) {
  Facets body = tube(60.0, 1, 400.0, 8, 0.0);
  for (Point& point : body.points) {
    if (point[2] < 200.0) continue;
    const double angle = std::atan2(point[1], point[0]) - M_PI / 8.0, radius = std::hypot(point[0], point[1]);
    point = {radius * std::cos(angle), radius * std::sin(angle), point[2]};
  }
  write("body.stl", stl(body, no_shift));
  write_sleeve({{"body.obj", "body.stl"}});
  const Outcome run = toile("check scene.xml");
  EXPECT_THAT(run.out + run.err,
              AllOf(HasSubstr("strips that turn along their length"), HasSubstr("mm inside the round body")));
}

/// Prism of `faces` flat faces on a circle of 60 mm, each cut into four across and 40 along.
Facets prism(int faces) {
  constexpr int cuts = 4;
  Facets body = tube(60.0, 40, 10.0, cuts * faces);
  const double half = M_PI / faces;
  for (Point& point : body.points) {
    if (std::hypot(point[0], point[1]) < 1.0) continue;
    const double angle = std::atan2(point[1], point[0]);
    const double from = 2.0 * half * std::floor(angle / (2.0 * half) + 1e-9);
    const double share = (angle - from) / (2.0 * half), apothem = 60.0 * std::cos(half);
    const double along = 60.0 * std::sin(half) * (2.0 * std::round(cuts * share) / cuts - 1.0);
    const double middle = from + half;
    point[0] = apothem * std::cos(middle) - along * std::sin(middle);
    point[1] = apothem * std::sin(middle) + along * std::cos(middle);
  }
  return body;
}

// Flat faces that were cut without being rounded are told with their width, angle and height; where nothing else is
// left of the body they are refused. A fine round body is neither.
TEST_F(Bodies, FlatFacesCutFurther) {
  write_sleeve();
  write("body.obj", obj(prism(24)));
  const Outcome warned = toile("check scene.xml");
  EXPECT_EQ(warned.status, 0) << warned.err;
  EXPECT_THAT(warned.err,
              AllOf(HasSubstr("warning: the body is made of coarse flat facets: faces about 16 mm wide that "
                              "meet at 15 degrees"),
                    HasSubstr("a round body lies up to 0.51 mm outside of them (0.86 % of its radius)"),
                    HasSubstr("Export the body with a finer tolerance")));
  write("body.obj", obj(prism(8)));
  expect_refused(AllOf(HasSubstr("body.obj"), HasSubstr("coarse flat facets: faces about 46 mm wide that meet at 45 "
                                                        "degrees")));
  write("body.obj", obj(tube(60.0, 60, 6.7, 60)));
  EXPECT_THAT(toile("check scene.xml").err, Not(HasSubstr("flat")));
}

// A scale that is given and makes no person of the body, where another unit would, is warned of with what it does to
// the garment; the scale that does, and one with a range of heights that says that a limb is meant, are not.
TEST_F(Bodies, ScaleOfAnotherUnit) {
  write("body.obj", obj(tube(60.0, 83, 20.0), {}, 1.0 / 25.4));
  const std::pair<std::string, std::string> tight = {"value=\"250.0\"", "value=\"120\""};
  write_sleeve({body(real("scale", 10.0)), tight});
  EXPECT_THAT(
      toile("check scene.xml").err,
      AllOf(HasSubstr("warning: the list \"Body\" has \"scale\" = 10, which makes the body 654 mm high; in inches "
                      "(\"scale\" = 25.4) it would be 1660 mm high, as a person is"),
            HasSubstr("panel \"sleeve\" would be stretched round it to 3.1"), HasSubstr(" instead of 1.2"),
            HasSubstr("\"height range\"")));
  write_sleeve({body(real("scale", 25.4)), tight});
  EXPECT_THAT(toile("check scene.xml").err, Not(HasSubstr("as a person is")));
  write_sleeve(
      {body(real("scale", 10.0) + "<Parameter name=\"height range\" type=\"Array(double)\" value=\"{300, 900}\"/>"),
       tight});
  EXPECT_THAT(toile("check scene.xml").err, Not(HasSubstr("as a person is")));
}

}  // namespace
}  // namespace toile::test
