// A sleeve over a groove of a cylinder of 60 mm: the fabric spans it, and its tension is the same all round.
#include "cases/line_stations.hpp"
#include "cases/sleeve_on_body.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

constexpr double radius = 60.0, depth = 15.0, height = 82.0;     // mm
constexpr double side = 5.0;                                     // mm, of the body's facets
constexpr double half_angle = M_PI / 6.0, narrow = M_PI / 18.0;  // halves of the angle in which the walls meet

/// Where the groove's wall meets the cylinder: radians from the groove's middle.
double shoulder(double half) {
  const double bottom = radius - depth, sine = std::sin(half), cosine = std::cos(half);
  const double wall = -bottom * cosine + std::sqrt(radius * radius - bottom * bottom * sine * sine);
  return std::asin(wall * sine / radius);
}

/// The way round the cylinder and across the groove, mm.
double girth() {
  return radius * (2.0 * M_PI - 2.0 * shoulder(half_angle)) + 2.0 * radius * std::sin(shoulder(half_angle));
}

/// A prism about z whose groove is at `middle` rad.
Facets grooved(double middle, double half) {
  std::vector<std::array<double, 2>> outline;
  const auto add = [&](double x, double y) {
    outline.push_back({x * std::cos(middle) - y * std::sin(middle), x * std::sin(middle) + y * std::cos(middle)});
  };
  const double first = shoulder(half), arc = 2.0 * M_PI - 2.0 * first;
  const auto pieces = static_cast<int>(std::lround(radius * arc / side));
  for (int k = 0; k <= pieces; ++k)
    add(radius * std::cos(first + arc * k / pieces), radius * std::sin(first + arc * k / pieces));
  const double x = radius * std::cos(first), y = radius * std::sin(first), bottom = radius - depth;
  const auto steps = static_cast<int>(std::lround(std::hypot(x - bottom, y) / side));
  for (int k = 1; k < 2 * steps; ++k) {
    const double share = std::abs(1.0 - static_cast<double>(k) / steps);
    add(bottom + share * (x - bottom), (k < steps ? -y : y) * share);
  }
  Facets prism;
  const int around = static_cast<int>(outline.size()), rows = 60;
  std::vector<int> lower, upper;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < around; ++i) {
      prism.points.push_back({outline[i][0], outline[i][1], -100.0 + side * j});
      if (j == 0) lower.insert(lower.begin(), i);
      if (j == rows) upper.push_back(j * around + i);
      if (j < rows)
        prism.facets.push_back(
            {j * around + i, j * around + (i + 1) % around, (j + 1) * around + (i + 1) % around, (j + 1) * around + i});
    }
  prism.facets.push_back(lower);
  prism.facets.push_back(upper);
  return prism;
}

class Grooves : public Bodies {
 protected:
  static constexpr double middle = 2.0;  // rad, off the sleeve's seam

  /// What the sleeve needs to lie round a cylinder that spans the groove, with an output.
  static Edits spanning(const std::string& output) {
    return {{text("type", "wrap"), text("type", "free wrap")},
            {"<Parameter name=\"offset\" type=\"double\" value=\"0.3\"/>",
             "<Parameter name=\"around\" type=\"Array(double)\" value=\"{60.3, 60.3}\"/>"},
            {"<ParameterList name=\"Output\">", "<ParameterList name=\"Output\">" + output}};
  }
};

// On the walls of a groove that the fabric spans there is no pressure, and the gap is the way to the fabric; away from
// it the pressure is T/r, within a told error that says nothing of the shoulders.
TEST_F(Grooves, AreSpanned) {
  const double width = girth() / 1.3;
  write("body.obj", obj(grooved(middle, half_angle)));
  const std::string elements = "name=\"elements across\" type=\"int\" value=\"32\"";
  const std::string output = "<ParameterList name=\"Output\">";
  write_sleeve(
      {{"value=\"250.0\"", "value=\"" + std::to_string(width) + "\""},
       {elements, "name=\"elements across\" type=\"int\" value=\"100\""},
       {"name=\"elements along\" type=\"int\" value=\"5\"", "name=\"elements along\" type=\"int\" value=\"14\""},
       {output, output + "<ParameterList name=\"Lines\"><ParameterList name=\"round\">" + text("type", "level") +
                    real("height", height) + "<Parameter name=\"from\" type=\"Array(double)\" value=\"{60, 0, 82}\"/>" +
                    "<Parameter name=\"stations\" type=\"int\" value=\"181\"/></ParameterList></ParameterList>"}});
  const Outcome outcome = toile("run scene.xml --output results");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const double laplace = pressure_of(width * 2.0 * M_PI * radius / girth());
  int inside = 0, away = 0;
  for (const Station& at : line_stations(read("results/pressure-lines.csv"))) {
    const double below = radius - std::hypot(at.x, at.y);
    const double angle = std::remainder(std::atan2(at.y, at.x) - middle, 2.0 * M_PI);
    if (below > 2.0) {
      ++inside;
      EXPECT_EQ(at.kpa, 0.0) << "depth " << below;
      EXPECT_FALSE(std::abs(at.gap - below) > 0.4 * below) << "depth " << below << ", gap " << at.gap;
    } else if (radius * (std::abs(angle) - shoulder(half_angle)) > 45.0) {
      ++away;
      EXPECT_NEAR(at.kpa, laplace, 0.03 * laplace) << "angle " << angle;
      EXPECT_NEAR(at.kpa, laplace, at.error_kpa) << "angle " << angle;
      EXPECT_LT(at.error_kpa, 0.15 * laplace) << "angle " << angle;
    }
  }
  EXPECT_GE(inside, 8);
  EXPECT_GE(away, 110);
}

// A panel that is wrapped into a groove too narrow for a smooth surface is refused with its place and with the
// placement that spans it, of which that is true.
TEST_F(Grooves, NarrowAreForFreeWrap) {
  write("body.obj", obj(grooved(middle, narrow)));
  write_sleeve();
  const Outcome wrapped = toile("check scene.xml");
  EXPECT_EQ(wrapped.status, 2);
  EXPECT_THAT(wrapped.err,
              AllOf(HasSubstr("scene > Panels > sleeve > Placement"),
                    HasSubstr("the body has a groove or slit too narrow to be wrapped (a panel that spans it is placed "
                              "by \"free wrap\") near "),
                    ContainsRegex("near 1(09|1[0-9]|20)[.0-9]* degrees")));
  write_sleeve(spanning(""));
  const Outcome spanned = toile("check scene.xml");
  EXPECT_EQ(spanned.status, 0) << spanned.err;
}

// A line that runs through such a groove and a point on its wall are refused with that reason.
TEST_F(Grooves, NarrowHaveNoLinesAndPoints) {
  write("body.obj", obj(grooved(0.0, narrow)));
  const std::string reason = "where the body has no smooth surface: a groove or slit is too narrow for one";
  const auto array = [](const std::string& name, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"Array(double)\" value=\"" + value + "\"/>";
  };
  write_sleeve(spanning("<ParameterList name=\"Lines\"><ParameterList name=\"round\">" + text("type", "level") +
                        real("height", height) + array("from", "{-60, 0, 82}") + "</ParameterList></ParameterList>"));
  EXPECT_THAT(toile("check scene.xml").err,
              AllOf(HasSubstr("Lines > round: parameter \"height\" = 82: the line passes ("), HasSubstr(reason)));
  write_sleeve(spanning("<ParameterList name=\"Body points\"><ParameterList name=\"wall\">" +
                        array("at", "{50, -0.9, 82}") + "</ParameterList></ParameterList>"));
  EXPECT_THAT(toile("check scene.xml").err,
              HasSubstr("Body points > wall: parameter \"at\" = {50, -0.9, 82}: (50, -0.9, 82) lies " + reason));
}

}  // namespace
}  // namespace toile::test
