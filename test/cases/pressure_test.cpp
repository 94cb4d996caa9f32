// Pressures that were not those of the fabric: on triangles and graded meshes, at nodes that a support holds.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "app/exodus.hpp"
#include "app/program.hpp"
#include "toile/base/csv_file.hpp"

namespace toile::test {
namespace {

class Pressure : public ProgramTest {
 protected:
  /// Runs test/data/cases/pressure/<name>.xml with each text replaced wherever it stands.
  void run(const std::string& name, const Edits& edits) {
    std::ifstream stream(TOILE_SOURCE_DIR "/test/data/cases/pressure/" + name + ".xml");
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    for (const auto& [from, to] : edits) {
      size_t at = text.find(from);
      ASSERT_NE(at, std::string::npos) << name << " does not contain " << from;
      for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
    }
    write("scene.xml", text);
    const Outcome outcome = toile("run scene.xml --output out");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    said_ = outcome.out + outcome.err;
  }
  const std::string& said() const { return said_; }
  /// A field at the garment's nodes, in their order: those of the body, behind them, have no area.
  std::vector<double> field(const std::string& name) const {
    const ExodusStep last(path("out/results.exo"));
    std::vector<double> values = last.nodal(name);
    const std::vector<double> area = last.nodal("area");
    values.resize(static_cast<size_t>(std::find(area.begin(), area.end(), 0.0) - area.begin()));
    return values;
  }
  void expect_everywhere(double kpa, double tolerance) const {
    const std::vector<double> pressure = field("pressure"), error = field("pressure_error");
    ASSERT_FALSE(pressure.empty());
    for (size_t n = 0; n < pressure.size(); ++n) {
      EXPECT_NEAR(pressure[n], kpa, tolerance * kpa) << "node " << n + 1;
      EXPECT_LE(error[n], 2.0 * tolerance * kpa) << "node " << n + 1;
    }
  }

 private:
  std::string said_;
};

/// Parts of sleeve.xml that the tests replace.
const std::string triangle = R"(value="triangle")", uniform = R"(value="1.0")", thin = R"(value="0.5")",
                  middle = R"(name="contact surface" type="string" value="mid-surface")";

// The pressure of a sleeve on a cylinder is 1.0931 kPa at every node, edges and seam too, on quadrilaterals and on
// triangles, on uniform and on graded meshes. The widest elements of the graded one are 15 mm, so it needs twice as
// many.
TEST_F(Pressure, IsTheSameOnTrianglesAndGradedMeshes) {
  for (const std::string elements : {"triangle", "quadrilateral"}) {
    const std::string kind = "value=\"" + elements + "\"";
    run("sleeve", {{triangle, kind}});
    expect_everywhere(1.0931, 0.005);
    run("sleeve", {{triangle, kind}, {uniform, R"(value="1.6")"}});
    expect_everywhere(1.0931, 0.01);
    run("sleeve", {{triangle, kind}, {uniform, R"(value="1.6")"}, {R"(value="40")", R"(value="80")"}});
    expect_everywhere(1.0931, 0.005);
  }
}

// A fabric of 4 mm on its inner face presses with 9.1395 kPa per area of its mid-surface, on triangles too, and with
// 9.3843 kPa per area of its inner face, which is what the skin feels.
TEST_F(Pressure, IsPerTheAreaThatIsAskedFor) {
  const std::string inner = R"(name="contact surface" type="string" value="inner face")";
  run("sleeve", {{thin, "value=\"4.0\""}, {middle, inner}});
  expect_everywhere(9.1395, 0.005);
  run("sleeve", {{thin, "value=\"4.0\""},
                 {middle + "/>", inner + R"(/><Parameter name="pressure area" type="string" value="inner face"/>)"}});
  expect_everywhere(9.3843, 0.005);
}

// On triangles of membranes and of shells the pressure of a sleeve on a cylinder converges with second order to T/R.
TEST_F(Pressure, OfTrianglesIsOfSecondOrder) {
  constexpr double c10 = 8.4667e-3, stretch = 1.2, radius = 60.0;  // MPa, hoop, mm
  const double axial = 1.0 / std::sqrt(stretch);                   // free end
  const double exact = 1e3 * 2.0 * c10 / axial * (stretch - std::pow(axial, -2) * std::pow(stretch, -3)) / radius;
  const Edits shell = {
      {"      <ParameterList name=\"Placement\">",
       "      <ParameterList name=\"Shell\"/>\n      <ParameterList name=\"Placement\">"},
      {"  <ParameterList name=\"Supports\">",
       "  <ParameterList name=\"Supports\">\n    <ParameterList name=\"seam\"><Parameter name=\"on\" "
       "type=\"Array(string)\" value=\"{sleeve.left, sleeve.right}\"/><Parameter name=\"hold\" type=\"string\" "
       "value=\"y\"/><Parameter name=\"director\" type=\"string\" value=\"symmetry\"/></ParameterList>"}};
  for (const Edits& kind : {Edits(), shell}) {
    std::array<double, 2> error{};
    for (const int level : {0, 1}) {
      Edits edits = kind;
      edits.push_back({R"(value="24")", "value=\"" + std::to_string(24 << level) + "\""});
      edits.push_back({R"(value="8")", "value=\"" + std::to_string(8 << level) + "\""});
      run("cylinder-triangle", edits);
      for (const double p : field("pressure"))
        error[static_cast<size_t>(level)] = std::max(error[static_cast<size_t>(level)], std::abs(p / exact - 1.0));
    }
    EXPECT_LE(error[1], 0.01);
    EXPECT_GE(std::log2(error[0] / error[1]), 1.8);
  }
}

// An end that is held in all directions with its mid-surface on the body lies half a thickness inside: the run tells
// it. With an offset of half a thickness and more it does not.
TEST_F(Pressure, BesideNodesHeldInsideTheBodyIsWarnedOf) {
  const std::string at = R"(name="offset" type="double" value="0.3")", hold = R"(name="hold" type="string" value="z")";
  const std::string coverage = R"(name="coverage" type="double" value="0.97")",
                    closed = R"(name="coverage" type="double" value="1.0")";
  const std::string inner = R"(name="contact surface" type="string" value="inner face")";
  const std::string all = R"(name="hold" type="string" value="xyz")";
  run("sleeve", {{middle, inner}, {hold, all}, {coverage, closed}, {at, R"(name="offset" type="double" value="0.0")"}});
  EXPECT_NE(said().find("supports hold 41 nodes inside the body"), std::string::npos) << said();
  run("sleeve",
      {{middle, inner}, {hold, all}, {coverage, closed}, {at, R"(name="offset" type="double" value="0.26")"}});
  EXPECT_EQ(said().find("inside the body, up to"), std::string::npos) << said();
}

// On a stocking that is held along z everywhere, the pressure on the seam is that beside it, on two meshes, and the
// same on both: what the support takes is no pressure.
TEST_F(Pressure, OnASeamIsThatBesideIt) {
  std::array<double, 2> ankle{};
  for (const int mesh : {0, 1}) {
    const int across = 15 << mesh, along = 50;
    run("seam-line",
        {{"INPUT", TOILE_SOURCE_DIR "/input"}, {"ACROSS", std::to_string(across)}, {"ALONG", std::to_string(along)}});
    const std::vector<double> pressure = field("pressure");
    const auto at = [&](int panel, int i, int j) {
      return pressure[static_cast<size_t>((panel * (along + 1) + j) * (across + 1) + i)];
    };
    for (int j = 0; j <= along; ++j) {
      EXPECT_NEAR(at(0, across, j), at(0, across - 1, j), 0.03 * at(0, across, j)) << "front, row " << j;
      EXPECT_NEAR(at(1, 0, j), at(0, across, j), 0.03 * at(0, across, j)) << "seam, row " << j;
    }
    ankle[static_cast<size_t>(mesh)] = at(0, across, 2);
  }
  EXPECT_NEAR(ankle[0], ankle[1], 0.01 * ankle[1]);
}

// Over the hollow of a body no fabric presses; a point of it beside fabric that presses may do so, and its error says
// how much. In the middle of the hollow there is no doubt.
TEST_F(Pressure, OfAPointAtTheEdgeOfContactIsInDoubt) {
  std::string points = "<ParameterList name=\"Points\">";
  for (int y = 0; y <= 100; y += 5)
    points += "<ParameterList name=\"p" + std::to_string(y) +
              "\"><Parameter name=\"on\" type=\"string\" value=\"sleeve@(160 " + std::to_string(y) +
              ")\"/></ParameterList>";
  const std::string levels = "<ParameterList name=\"Levels\">";
  write_scene("sleeve", {{"value=\"cylinder\"", "value=\"cosine\""},
                         {"value=\"60\"/>",
                          "value=\"60\"/><Parameter name=\"amplitude\" type=\"double\" value=\"9\"/>"
                          "<Parameter name=\"period\" type=\"double\" value=\"130\"/>"},
                         {"name=\"elements along\" type=\"int\" value=\"9\"",
                          "name=\"elements along\" type=\"int\" value=\"20\""},
                         {"value=\"200\"", "value=\"320\""},
                         {levels, points + "</ParameterList>" + levels}});
  const Outcome outcome = toile("run scene.xml --output out");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const base::CsvFile table = base::read_csv(path("out/pressure-points.csv"), "point");
  const auto column = [&table](const std::string& name) {
    const auto named = [&name](const base::CsvColumn& one) { return one.name == name; };
    return base::numbers(table, *std::find_if(table.columns.begin(), table.columns.end(), named));
  };
  const std::vector<double> pressure = column("pressure"), error = column("its error");
  ASSERT_EQ(pressure.size(), 21U);
  int in_doubt = 0, free = 0;
  for (size_t i = 1; i + 1 < pressure.size(); ++i) {
    if (pressure[i] > 0.0) continue;
    const double beside = std::max(pressure[i - 1], pressure[i + 1]);
    ++(beside > 0.0 ? in_doubt : free);
    EXPECT_NEAR(error[i], beside, 0.01 * beside) << 5 * i << " mm";
  }
  EXPECT_EQ(in_doubt, 2);
  EXPECT_GT(free, 3);
}

}  // namespace
}  // namespace toile::test
