// Pressure along lines on the body: a sleeve on a cylinder of 60 mm, whose pressure is T/r everywhere.
#include <cmath>

#include "cases/line_stations.hpp"
#include "cases/sleeve_on_body.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

class PressureLines : public ProgramTest {
 protected:
  /// The sleeve with one line, whose parameters are given.
  void write_sleeve(const std::string& line) const {
    std::ifstream stream(TOILE_SOURCE_DIR "/test/data/cases/pressure/sleeve.xml");
    std::string scene((std::istreambuf_iterator<char>(stream)), {});
    const std::string output = "<ParameterList name=\"Output\">";
    scene.replace(scene.find(output), output.size(),
                  output + "<ParameterList name=\"Lines\"><ParameterList name=\"tape\">" + line +
                      "</ParameterList></ParameterList>");
    write("scene.xml", scene);
  }
  static std::string numbers(const std::string& name, const std::string& values) {
    return "<Parameter name=\"" + name + "\" type=\"Array(double)\" value=\"{" + values + "}\"/>";
  }
  static std::string way(const std::string& through) {
    return text("type", "shortest way") + numbers("through", through);
  }
  std::vector<Station> run() const {
    const Outcome outcome = toile("run scene.xml --output out");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return line_stations(read("out/pressure-lines.csv"));
  }
  std::string refused(const std::string& line) const {
    write_sleeve(line);
    const Outcome outcome = toile("check scene.xml");
    EXPECT_EQ(outcome.status, 2);
    return outcome.err;
  }
};

constexpr double radius = 60.0;     // mm
constexpr double laplace = 1.0931;  // kPa, pressure_of(250)

// Round the cylinder the pressure is T/r at every station; they lie on it at equal distances, and the length is that of
// the circle, whose facets of 5 mm it does not show.
TEST_F(PressureLines, RoundACylinderIsLaplaces) {
  ASSERT_NEAR(pressure_of(250.0), laplace, 1e-4);
  write_sleeve(way("60, 0, 100, -30, 51.9615, 100, -30, -51.9615, 100, 60, 0, 100") +
               R"(<Parameter name="stations" type="int" value="61"/>)");
  const std::vector<Station> line = run();
  ASSERT_EQ(line.size(), 61u);
  EXPECT_NEAR(line.back().length, 2.0 * M_PI * radius, 1e-4 * 2.0 * M_PI * radius);
  for (size_t s = 0; s < line.size(); ++s) {
    EXPECT_EQ(line[s].line, "tape");
    EXPECT_NEAR(line[s].length, line.back().length * static_cast<double>(s) / 60.0, 1e-6);
    EXPECT_NEAR(std::hypot(line[s].x, line[s].y), radius, 1e-6);
    EXPECT_NEAR(line[s].kpa, laplace, 0.005 * laplace) << s;
    EXPECT_NEAR(line[s].mmhg, 7.50062 * line[s].kpa, 1e-5);
    EXPECT_GT(line[s].error_kpa, 0.0);
    EXPECT_LT(line[s].error_kpa, 0.02 * laplace);
    EXPECT_NEAR(line[s].error_mmhg, 7.50062 * line[s].error_kpa, 1e-5);
    EXPECT_LT(std::abs(line[s].gap), 1e-6);
  }
  EXPECT_TRUE(exists("out/pressure-lines.svg"));
}

// Beyond the garment there is no pressure and no gap.
TEST_F(PressureLines, GoOnBeyondTheGarment) {
  write_sleeve(way("60, 0, 80, -60, 0, 190"));
  const std::vector<Station> line = run();
  ASSERT_EQ(line.size(), 101u);
  for (const Station& s : line) {
    if (s.z < 138.0) {
      EXPECT_NEAR(s.kpa, laplace, 0.01 * laplace) << s.z;
    } else if (s.z > 145.0) {
      EXPECT_EQ(s.kpa, 0.0) << s.z;
      EXPECT_TRUE(std::isnan(s.gap)) << s.z;
    }
  }
}

// A line at a level is the section across the axis, a bent one's as well; it may end before it has run round.
TEST_F(PressureLines, LevelAlongTheAxis) {
  write_sleeve(text("type", "level") + real("height", 100.0) + numbers("from", "0, 900, 0") +
               numbers("to", "0, -900, 0"));
  std::ifstream stream(path("scene.xml"));
  std::string scene((std::istreambuf_iterator<char>(stream)), {});
  std::vector<Station> line = run();
  ASSERT_EQ(line.size(), 101u);
  EXPECT_NEAR(line.back().length, M_PI * radius, 1e-4 * M_PI * radius);
  for (const Station& s : line) {
    EXPECT_NEAR(s.z, 100.0, 1e-6);
    EXPECT_LT(s.x, 0.1);
    EXPECT_NEAR(std::atan2(-s.x, s.y), s.length / radius, 0.01);
  }
  // An axis that leaves the cylinder's by 0.2 a mm: the section is an ellipse about its point there.
  const std::string output = "<ParameterList name=\"Output\">";
  scene.replace(scene.find(output), output.size(), output + numbers("axis", "0, 0, 0, 0, 10, 50, 0, 20, 100"));
  scene.replace(scene.find("name=\"stations\" type=\"int\" value=\"11\""), 37,
                "name=\"stations\" type=\"int\" value=\"0\"");
  write("scene.xml", scene);
  line = run();
  const double height = 100.0 / std::hypot(1.0, 0.2), tilt = std::hypot(1.0, 0.2);
  for (const Station& s : line) EXPECT_NEAR((s.z - height) + 0.2 * (s.y - 0.2 * height), 0.0, 0.1) << tilt;
}

// Points that make no line on the body are refused before anything is solved.
TEST_F(PressureLines, WithoutAWayAreRefused) {
  const std::string parameter = "scene > Output > Lines > tape: parameter \"through\"";
  EXPECT_THAT(refused(way("60, 0, 100, 0, 60")), HasSubstr(parameter));
  EXPECT_THAT(refused(way("60, 0, 100, 0, 60")), HasSubstr("found 5 numbers, expected x, y, z of each point"));
  EXPECT_THAT(refused(way("60, 0, 100")), HasSubstr("found 1 point, expected at least 2"));
  EXPECT_THAT(refused(way("60, 0, 100, 60, 0, 100")), HasSubstr("its points lie at one place of the body"));
  EXPECT_THAT(refused(way("60, 0, 100, -95, 0, 100")), HasSubstr("(-95, 0, 100) lies 35 mm from the body's skin"));
  EXPECT_THAT(refused(text("type", "geodesic")), HasSubstr("shortest way"));
}

// Cuts that are none, or that do not say where they start, are refused likewise.
TEST_F(PressureLines, WithoutACutAreRefused) {
  const std::string cut = text("type", "cut");
  EXPECT_THAT(refused(cut + numbers("at", "0, 0, 100") + numbers("normal", "0, 0, 1")),
              HasSubstr("parameter \"at\" = {0, 0, 100}: (0, 0, 100) does not lie on the body's skin, so it does not "
                        "say where the line starts; give \"from\""));
  EXPECT_THAT(refused(cut + numbers("at", "60, 0, 100") + numbers("normal", "0, 0, 0")),
              HasSubstr("parameter \"normal\" = {0, 0, 0}: must not be zero"));
  EXPECT_THAT(refused(cut + numbers("at", "60, 0, 100, 1, 2, 3") + numbers("normal", "0, 0, 1")),
              HasSubstr("found 2 points, expected one"));
  EXPECT_THAT(refused(cut + numbers("at", "0, 0, 5000") + numbers("from", "60, 0, 0") + numbers("normal", "0, 0, 1")),
              HasSubstr("the plane through (0, 0, 5000) misses the body"));
  EXPECT_THAT(refused(cut + numbers("at", "60, 0, 100") + numbers("to", "61, 0, 100") + numbers("normal", "0, 0, 1")),
              HasSubstr("the line would end where it starts"));
  EXPECT_THAT(refused(text("type", "level") + real("height", 100.0)), HasSubstr("missing parameter \"from\""));
}

}  // namespace
}  // namespace toile::test
