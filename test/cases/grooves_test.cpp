// A limb with a groove that is too narrow for a smooth surface: what cannot lie in it is told why.
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double radius = 60.0, bottom_radius = 45.0;  // mm

/// The corners of a circle with a groove at the angle 0 whose sides meet at 20 degrees, 5 mm apart.
std::vector<std::array<double, 2>> grooved_circle() {
  const double half = M_PI / 18.0, c = bottom_radius * std::cos(half);
  const double side = -c + std::sqrt(c * c + radius * radius - bottom_radius * bottom_radius);
  const double x = bottom_radius + side * std::cos(half), y = side * std::sin(half), lip = std::atan2(y, x);
  const int steps = static_cast<int>(std::lround(radius * 2.0 * (M_PI - lip) / 5.0));
  std::vector<std::array<double, 2>> corners;
  for (int k = 0; k < steps; ++k) {
    const double angle = lip + 2.0 * (M_PI - lip) * k / steps;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  for (const double part : {0.0, 1.0 / 3.0, 2.0 / 3.0})
    corners.push_back({x + part * (bottom_radius - x), -y * (1.0 - part)});
  for (const double part : {0.0, 1.0 / 3.0, 2.0 / 3.0})
    corners.push_back({bottom_radius + part * (x - bottom_radius), y * part});
  return corners;
}

/// As an OBJ file, from z = -80 to 190 mm.
std::string grooved_limb() {
  constexpr int rings = 55;
  const std::vector<std::array<double, 2>> circle = grooved_circle();
  const auto around = circle.size();
  std::ostringstream obj;
  for (int r = 0; r < rings; ++r)
    for (const auto& [x, y] : circle) obj << "v " << x << ' ' << y << ' ' << 5 * r - 80 << '\n';
  const auto at = [&](std::size_t ring, std::size_t k) { return ring * around + k % around + 1; };
  for (std::size_t r = 0; r + 1 < rings; ++r)
    for (std::size_t k = 0; k < around; ++k)
      obj << "f " << at(r, k) << ' ' << at(r, k + 1) << ' ' << at(r + 1, k + 1) << ' ' << at(r + 1, k) << '\n';
  obj << 'f';
  for (std::size_t k = around; k > 0; --k) obj << ' ' << k;
  obj << "\nf";
  for (std::size_t k = 0; k < around; ++k) obj << ' ' << at(rings - 1, k);
  return obj.str() + "\n";
}

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

class Groove : public ProgramTest {
 protected:
  void SetUp() override { write("limb.obj", grooved_limb()); }

  /// The sleeve of input/benchmarks on the limb, with a placement and outputs.
  Outcome check(const std::string& placement, const std::string& output) const {
    const std::string body = parameter("replace", "bool", "true") + parameter("type", "string", "file") +
                             parameter("file", "string", "limb.obj") +
                             parameter("height range", "Array(double)", "{50, 1000}");
    write("scene.xml",
          list("scene",
               parameter("include", "Array(string)", "{" TOILE_SOURCE_DIR "/input/benchmarks/sleeve-cylinder.xml}") +
                   list("Body", body) + list("Panels", list("sleeve", list("Placement", placement))) +
                   list("Output", output)));
    return toile("check scene.xml");
  }
  /// Spanning the groove.
  static std::string free_wrap() {
    return parameter("replace", "bool", "true") + parameter("type", "string", "free wrap") +
           parameter("axis bottom", "Array(double)", "{0, 0, 0}") +
           parameter("axis top", "Array(double)", "{0, 0, 1}") + parameter("from", "double", "0") +
           parameter("to", "double", "110") + parameter("coverage", "double", "1") +
           parameter("around", "Array(double)", "{60.5, 60.5}");
  }
};

// A panel that is wrapped into it is refused with the place of the groove and the placement that spans it, which is
// none for this one.
TEST_F(Groove, PanelIsPlacedByFreeWrap) {
  const Outcome wrapped = check("", "");
  EXPECT_EQ(wrapped.status, 2);
  EXPECT_THAT(wrapped.err, AllOf(HasSubstr("scene > Panels > sleeve > Placement"),
                                 HasSubstr("the body has a groove or slit too narrow to be wrapped (a panel that spans "
                                           "it is placed by \"free wrap\") at 0 degrees from \"zero direction\"")));
  const Outcome spanned = check(free_wrap(), "");
  EXPECT_EQ(spanned.status, 0) << spanned.err;
}

// So is a level line that runs through it, and a point of the body on its side.
TEST_F(Groove, LinesAndPointsLieBesideIt) {
  const std::string line = parameter("type", "string", "level") + parameter("height", "double", "55") +
                           parameter("from", "Array(double)", "{-60, 0, 55}");
  EXPECT_THAT(check(free_wrap(), list("Lines", list("round", line))).err,
              AllOf(HasSubstr("Lines > round: parameter \"height\""), HasSubstr("the line passes ("),
                    HasSubstr("where the body has no smooth surface: a groove or slit is too narrow for one")));
  EXPECT_THAT(
      check(free_wrap(), list("Body points", list("side", parameter("at", "Array(double)", "{50, -0.9, 55}")))).err,
      AllOf(HasSubstr("Body points > side: parameter \"at\""),
            HasSubstr("(50, -0.9, 55) lies where the body has no smooth surface")));
}

}  // namespace
}  // namespace toile::test
