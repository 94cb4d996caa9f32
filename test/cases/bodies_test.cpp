#include <algorithm>
#include <cmath>
#include <random>

#include "app/exodus.hpp"
#include "cases/sleeve_on_body.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// One tube in six dialects of OBJ gives one pressure.
TEST_F(Bodies, DialectsOfObj) {
  const Facets body = tube(60.0, 20, 20.0);
  Dialect tabs, loose, relative, coloured, continued;
  tabs.between = "\t";
  loose.head = "o body\nl 1 2\n";
  relative.corner = [](int c, int points) { return std::to_string(c - points); };
  coloured.head = "mtllib none.mtl\nusemtl skin\nvt 0 0\nvn 0 0 1\n";
  coloured.behind_vertex = " 0.8 0.6 0.5";
  coloured.corner = [](int c, int) { return std::to_string(c + 1) + "/1/1"; };
  continued.between = " \\\n  ";
  write_sleeve();
  for (const Dialect& dialect : {Dialect(), tabs, loose, relative, coloured, continued}) {
    write("body.obj", obj(body, dialect));
    SCOPED_TRACE(read("body.obj").substr(0, 60));
    expect_pressure(pressure_of(250.0), mesh_error);
  }
}

// Bare facets, on which no equilibrium is found, are refused with the reason before anything is solved.
TEST_F(Bodies, BareFacets) {
  write("body.obj", obj(tube(60.0, 20, 20.0)));
  write_sleeve({body(text("surface", "facets"))});
  expect_refused(
      HasSubstr("bare facets are refused: without friction, fabric comes to rest on the edges between them"));
}

// A vertex that stands half a millimetre out of a tube: results.exo shows on the smooth surface below it, and nowhere
// as much, how far that passes below it, which is what the summary tells.
TEST_F(Bodies, ErrorOfTheSmoothSurface) {
  Facets body = tube(60.0, 20, 20.0);
  const std::array<double, 3> tip{60.5, 0.0, 140.0};
  body.points[12 * 36] = tip;
  write("body.obj", obj(body));
  write_sleeve();
  const std::string out = expect_pressure(pressure_of(250.0), mesh_error);
  const ExodusStep step(path("results/results.exo"));
  const std::vector<double> error = step.nodal("body_error");
  ASSERT_FALSE(error.empty());
  const std::size_t worst = std::min_element(error.begin(), error.end()) - error.begin();
  const auto off = [&](std::size_t k) { return tip[k] - step.position[k][worst]; };
  EXPECT_NEAR(std::hypot(off(0), off(1), off(2)), -error[worst], 1e-6);
  EXPECT_GT(error[worst], -0.5);
  EXPECT_LT(error[worst], -0.1);
  const std::size_t told = out.find("% of the area, from ");
  ASSERT_NE(told, std::string::npos);
  EXPECT_NEAR(std::strtod(&out[told + 20], nullptr) / error[worst], 1.0, 5e-3);
}

// The garment lies on the outer surface of a hollow body, whatever repair is asked for, and the cavity is told.
TEST_F(Bodies, HollowBody) {
  Facets hollow = tube(60.0, 20, 20.0);
  Facets cavity = tube(50.0, 19, 20.0);
  const int first = static_cast<int>(hollow.points.size());
  for (Point& point : cavity.points) hollow.points.push_back({point[0], point[1], point[2] + 10.0});
  for (const auto& facet : cavity.facets) {
    hollow.facets.emplace_back();
    for (auto c = facet.rbegin(); c != facet.rend(); ++c) hollow.facets.back().push_back(*c + first);
  }
  write("body.obj", obj(hollow));
  const std::string repair = flag("repair orientation", true);
  for (const std::string& parameters :
       {std::string(), repair,
        repair + "<ParameterList name=\"Reach\">" + real("bottom", 0.0) + real("top", 170.0) +
            "<Parameter name=\"seed\" type=\"Array(double)\" value=\"{50, 0, 80}\"/></ParameterList>"}) {
    write_sleeve({body(parameters)});
    EXPECT_THAT(expect_pressure(pressure_of(250.0), mesh_error),
                HasSubstr("pieces inside another left out: 1 (of them cavities, whose facets look inwards: 1)"));
  }
}

// A tube whose wall is open at both ends, so that the axis runs through air, is refused with that reason.
TEST_F(Bodies, OpenHollow) {
  constexpr int around = 36;
  Facets wall = tube(60.0, 20, 20.0);
  const Facets inner = tube(50.0, 20, 20.0);
  wall.points.resize(21 * around);  // without the caps
  wall.facets.clear();
  const int first = static_cast<int>(wall.points.size());
  wall.points.insert(wall.points.end(), inner.points.begin(), inner.points.begin() + first);
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around, top = 20 * around;
    for (int j = 0; j < 20; ++j) {
      const int a = j * around + i, b = j * around + next;
      wall.facets.push_back({a, b, b + around, a + around});
      wall.facets.push_back({b + first, a + first, a + around + first, b + around + first});
    }
    wall.facets.push_back({next, i, i + first, next + first});
    wall.facets.push_back({top + i, top + next, top + next + first, top + i + first});
  }
  write("body.obj", obj(wall));
  write_sleeve();
  expect_refused(
      AllOf(HasSubstr("the axis is not inside the body at the height 60 mm"),
            HasSubstr("mm away. Lay the axis through the limb; if the body is a hollow shell with an opening, "
                      "fill it")));
}

// A cylinder with vertices on its rims alone, or on one more ring, is a cylinder all along; nothing is warned of, as
// there is nothing wrong with it.
TEST_F(Bodies, LongTriangles) {
  for (const int rows : {1, 2}) {
    write("body.stl", stl(tube(60.0, rows, 400.0 / rows, 72), [] { return 0.0; }));
    write_sleeve({{"body.obj", "body.stl"}});
    EXPECT_THAT(expect_pressure(pressure_of(250.0), 2.0 * mesh_error), Not(HasSubstr("warning: the body")));
    std::istringstream curve(read("results/pressure-curve.csv"));
    std::string line;
    std::getline(curve, line);
    std::vector<double> pressures;
    while (std::getline(curve, line))
      pressures.push_back(std::strtod(line.substr(line.find(',') + 1).c_str(), nullptr));
    ASSERT_GE(pressures.size(), 7u);
    for (size_t i = 1; i + 1 < pressures.size(); ++i) EXPECT_NEAR(pressures[i] / pressure_of(250.0), 1.0, 0.02);
  }
}

// STL whose copies of one vertex differ in the last digit, all of them or some, is the same closed body, also for a
// user who asks for an open one.
TEST_F(Bodies, RoundedCopies) {
  const Facets body_facets = tube(60.0, 20, 20.0);
  std::mt19937 random(1);
  int count = 0;
  const std::function<double()> all = [&random] { return 4e-6 * (static_cast<double>(random()) / 4294967296.0 - 0.5); };
  const std::function<double()> few = [&count] { return ++count % 500 == 0 ? 2e-6 : 0.0; };
  const std::string open = flag("closed", false);
  for (const auto& [shift, parameters] : {std::pair(few, open), {all, std::string()}}) {
    write("body.stl", stl(body_facets, shift));
    write_sleeve({body(parameters), {"body.obj", "body.stl"}});
    EXPECT_THAT(expect_pressure(pressure_of(250.0), mesh_error), HasSubstr(" vertices welded that were up to "));
  }
}

// A body in inches is refused with every unit that would make a person of it; in inches it has the right pressure, also
// on a tight sleeve, and the summary tells its extents.
TEST_F(Bodies, Inches) {
  write("body.obj", obj(tube(60.0, 83, 20.0), {}, 1.0 / 25.4));
  write_sleeve();
  expect_refused(AllOf(HasSubstr("are 4.724 x 4.724 x 65.35 mm"),
                       HasSubstr("cm with z up (47.24 x 47.24 x 653.5 mm): \"scale\" = 10; "
                                 "inches with z up (120 x 120 x 1660 mm): \"scale\" = 25.4: you have to know which")));
  for (const double width : {250.0, 120.0}) {
    write_sleeve({body(real("scale", 25.4)), {"value=\"250.0\"", "value=\"" + std::to_string(width) + "\""}});
    EXPECT_THAT(expect_pressure(pressure_of(width), 2.0 * mesh_error), HasSubstr("120 x 120 x 1660 mm"));
  }
}

// A body with y up is refused with the way out, in its own unit and after scaling; turned it has the right pressure.
TEST_F(Bodies, YUp) {
  Facets figure = tube(60.0, 20, 20.0);
  for (Point& point : figure.points) point = {point[0], point[2], -point[1]};
  write("body.obj", obj(figure, {}, 1e-3));
  const std::string hint = "m with y up (120 x 120 x 400 mm): \"scale\" = 1000, \"up\" = \"y\"";
  write_sleeve();
  expect_refused(AllOf(HasSubstr("are 0.12 x 0.4 x 0.12 mm; it seems to lie, for y is the longest"), HasSubstr(hint)));
  write_sleeve({body(real("scale", 4000.0))});
  expect_refused(AllOf(HasSubstr("the body is 480 mm high"), HasSubstr(hint)));
  write_sleeve({body(real("scale", 1000.0) + text("up", "y"))});
  expect_pressure(pressure_of(250.0), mesh_error);
}

// A sleeve that reaches beyond the limb is refused with the height at which the body ends.
TEST_F(Bodies, BodyEndsBelowTheGarment) {
  write("body.obj", obj(tube(60.0, 20, 20.0)));
  write_sleeve({{"name=\"to\" type=\"double\" value=\"105.0\"", "name=\"to\" type=\"double\" value=\"350\""}});
  expect_refused(
      HasSubstr("parameter \"to\" = 350: the body ends at 300 mm along the axis, but the panel is wrapped "
                "from 60 to 350 mm"));
}

// Hostile files are refused with their name and the place in them.
TEST_F(Bodies, HostileFiles) {
  const auto expect_place = [this](const std::string& file, const std::string& content, const std::string& place) {
    write(file, content);
    write_sleeve({{"body.obj", file}});
    expect_refused(AllOf(HasSubstr(file + ": " + place), Not(HasSubstr("internal error"))));
  };
  expect_place("head.ply", "ply\nformat ascii 1.0\nproperty float x\n", "line 3: a property before any element");
  expect_place("list.ply",
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar float x\nproperty float y\n"
               "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n",
               "the property 'x' of 'vertex' must be a number, not a list");
  expect_place("huge.off", "OFF\n2147483647 224 0\n0 0 0\n1 0 0\n",
               "line 4: the file ends after 2 of the 2147483647 vertices");
  expect_place("far.obj", "v 1e308 0 50\nf 1 1 1\n", "line 1: a vertex has the coordinate 10000000");
  expect_place("corner.obj", "v 0 0 0\nf 1 2 2147483648\n", "line 2: a facet has the corner 2, but the file has 1");
}

}  // namespace
}  // namespace toile::test
