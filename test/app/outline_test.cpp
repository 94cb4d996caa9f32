// A panel of any outline, from the scene and from files of patterns, against the pressure of its even stretch.
#include <algorithm>
#include <cmath>
#include <fstream>

#include "exodus.hpp"
#include "program.hpp"
#include "toile/pattern/file.hpp"

namespace toile::test {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  return std::string((std::istreambuf_iterator<char>(stream)), {});
}

class Outline : public ProgramTest {
 protected:
  /// Runs armhole.xml with edits. The pattern is stretched evenly onto the cylinder and held at all of its edges, so
  /// that the even stretch is its equilibrium and p = T/R; with n sides round the girth, chords make 1/n^2 of it.
  void expect_even_pressure(const Edits& edits, double tolerance, double* rms = nullptr) {
    write_scene("armhole", edits);
    const Outcome outcome = toile("run scene.xml --output out");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const ExodusStep last(path("out/results.exo"));
    std::vector<double> pressure = last.nodal("pressure");
    const std::vector<double> area = last.nodal("area");
    const auto nodes = static_cast<size_t>(std::find(area.begin(), area.end(), 0.0) - area.begin());
    ASSERT_GT(nodes, 300U);
    constexpr double c10 = 0.05, thickness = 0.5, radius = 60.0;  // MPa, mm, mm
    const double hoop = 2.0 * M_PI * radius / 290.0, axial = 99.0 / 90.0;
    const double tension = 2.0 * c10 * thickness / axial * (hoop - std::pow(axial, -2) * std::pow(hoop, -3));
    const double exact = 1e3 * tension / radius;
    double squares = 0.0;
    for (size_t n = 0; n < nodes; ++n) {
      EXPECT_NEAR(pressure[n], exact, tolerance * exact) << "node " << n + 1;
      squares += std::pow(pressure[n] / exact - 1.0, 2);
    }
    if (rms != nullptr) *rms = std::sqrt(squares / static_cast<double>(nodes));
  }

  /// The panel of the scene in a file of patterns.
  void write_pattern(const std::string& file) const {
    using pattern::Curve;
    pattern::Panel panel;
    panel.name = "front";
    panel.outline = {{"hem", Curve::line({0, 0}, {290, 0})},
                     {"right", Curve::line({290, 0}, {290, 90})},
                     {"shoulder", Curve::line({290, 90}, {190, 90})},
                     {"armhole", Curve::cubic({190, 90}, {180, 20}, {110, 20}, {100, 90})},
                     {"neck", Curve::spline({{100, 90}, {50, 84}, {0, 90}})},
                     {"left", Curve::line({0, 90}, {0, 0})}};
    pattern::write_pattern({{panel}, {}}, path(file));
  }
};

const std::string outline = R"(name="shape" type="string" value="outline")";
const std::string quads = R"(<Parameter name="mesher" type="string" value="free"/>)";

// Quadrilaterals and triangles of a panel with an armhole have the pressure of the even stretch at every node, held
// ones and the seam too, and converge to it.
TEST_F(Outline, WithAnArmholePressesEvenly) {
  double coarse = 0.0, fine = 0.0;
  expect_even_pressure(
      {{R"(name="element size" type="double" value="5")", R"(name="element size" type="double" value="10")"}}, 0.02,
      &coarse);
  expect_even_pressure({}, 0.01, &fine);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
  expect_even_pressure({{quads, quads + R"(<Parameter name="elements" type="string" value="triangle"/>)"}}, 0.01);
}

// The same panel from a file of each format has the same pressure.
TEST_F(Outline, ComesFromFilesOfPatterns) {
  for (const std::string file : {"panel.json", "panel.dxf", "panel.svg"}) {
    write_pattern(file);
    std::string scene;
    write_scene("armhole");
    std::string text = read("scene.xml");
    const size_t from = text.find("<ParameterList name=\"Outline\">"), to = text.find(quads);
    const std::string of_file = R"(<Parameter name="file" type="string" value=")" + file + "\"/>";
    expect_even_pressure(
        {{outline, R"(name="shape" type="string" value="pattern file")"}, {text.substr(from, to - from), of_file}},
        0.01);
  }
}

// A garment of a file of patterns is read, meshed, sewn and placed by a list of three parameters.
TEST_F(Outline, OfAWholeGarmentComesFromOneFile) {
  write("tee.json", text_of(TOILE_SOURCE_DIR "/test/data/patterns/gpg_tee.json"));
  write("scene.xml", R"(<ParameterList name="scene">
  <ParameterList name="Materials"><ParameterList name="knit">
    <Parameter name="type" type="string" value="rebar"/><Parameter name="set" type="string" value="pantyhose"/>
  </ParameterList></ParameterList>
  <ParameterList name="Pattern">
    <Parameter name="file" type="string" value="tee.json"/>
    <Parameter name="material" type="string" value="knit"/>
    <Parameter name="element size" type="double" value="20"/>
  </ParameterList>
  <ParameterList name="Stages"><ParameterList name="sew"><Parameter name="type" type="string" value="sew"/>
    <ParameterList name="Damping"/></ParameterList></ParameterList>
</ParameterList>)");
  const Outcome outcome = toile("check scene.xml");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, ::testing::HasSubstr("12 seams, 1 stages"));
  EXPECT_THAT(outcome.out, ::testing::HasSubstr("panel \"front\": stretch 1 along the wale, 1 along the course"));
}

// A size that would fill the memory is refused before anything is meshed.
TEST_F(Outline, OfTooManyElementsIsRefused) {
  const std::string size = R"(name="element size" type="double" value=")";
  write_scene("armhole", {{size + "5\"", size + "0.02\""}});
  const Outcome outcome = toile("check scene.xml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, ::testing::AllOf(::testing::HasSubstr("\"element size\" = 0.02"),
                                            ::testing::HasSubstr("allowed are at most 1000000")));
}

// A part of an edge is sewn to another part; what is no part is told with what is valid.
TEST_F(Outline, IsSewnByParts) {
  const std::string first = R"(name="first" type="string" value="front.right")",
                    second = R"(name="second" type="string" value="front.left")";
  write_scene("armhole", {{first, R"(name="first" type="string" value="front.right[0:0.5]")"},
                          {second, R"(name="second" type="string" value="front.left[0.5:1]")"}});
  EXPECT_EQ(toile("check scene.xml").status, 0);
  write_scene("armhole", {{first, R"(name="first" type="string" value="front.right[0:middle]")"}});
  const Outcome outcome = toile("check scene.xml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, ::testing::AllOf(::testing::HasSubstr("Seams > side"), ::testing::HasSubstr("middle")));
}

}  // namespace
}  // namespace toile::test
