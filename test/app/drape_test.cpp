// Flat panels that are draped onto a body, settled, and have the pressure that they have by any other way.
#include <algorithm>
#include <cmath>

#include "exodus.hpp"
#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

class Draped : public ProgramTest {
 protected:
  /// The largest relative error of the pressure over the garment's nodes, against T/R of the even hoop stretch: the
  /// tube is free to shorten by its root. The third above the held edge is left out, which is held as it was draped.
  double largest_error(const Edits& edits) {
    write_scene("draped", edits);
    const Outcome outcome = toile("run scene.xml --output out");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const ExodusStep last(path("out/results.exo"));
    const std::vector<double> pressure = last.nodal("pressure"), area = last.nodal("area");
    const auto nodes = static_cast<size_t>(std::find(area.begin(), area.end(), 0.0) - area.begin());
    EXPECT_GT(nodes, 500U);
    constexpr double c10 = 0.05, thickness = 0.5, radius = 60.0;  // MPa, mm, mm
    const double hoop = 2.0 * M_PI * radius / 290.0;
    const double exact = 1e3 * 2.0 * c10 * thickness * (hoop - std::pow(hoop, -2)) * std::sqrt(hoop) / radius;
    double largest = 0.0;
    for (size_t n = 0; n < nodes; ++n) largest = std::max(largest, std::abs(pressure[n] / exact - 1.0));
    return largest;
  }
};

const std::string drape = R"(<ParameterList name="Drape"/>)", settle = R"(<ParameterList name="settle">)";

// The pressure is that of the even stretch, whether the panels were draped or sewn step by step.
TEST_F(Draped, BothWaysHaveTheSamePressure) {
  EXPECT_LT(largest_error({}), 0.01);
  const std::string sew = R"(<ParameterList name="sew"><Parameter name="type" type="string" value="sew"/>)"
                          R"(<ParameterList name="Damping"/></ParameterList>)";
  EXPECT_LT(largest_error({{drape, ""}, {settle, sew + settle}}), 0.01);
}

// A pattern that is far too small is refused with the stretch that it would need, and can be looked at; and so is a
// shell that takes the placed shape as its stress-free one: it would forget how it was stretched, and press nowhere.
TEST_F(Draped, RefusesWhatCannotBeDraped) {
  write_scene("draped", {{"value=\"145\"", "value=\"40\""}});
  const Outcome narrow = toile("check scene.xml --output start");
  EXPECT_EQ(narrow.status, 2);
  EXPECT_TRUE(exists("start/start.exo"));
  EXPECT_EQ(toile("run scene.xml").status, 2);
  write_scene("draped", {{"<ParameterList name=\"Placement\">",
                          "<ParameterList name=\"Shell\"><Parameter name=\"stress-free\" type=\"string\" "
                          "value=\"placed\"/></ParameterList><ParameterList name=\"Placement\">"}});
  const Outcome curved = toile("check scene.xml");
  EXPECT_EQ(curved.status, 2);
  EXPECT_THAT(curved.err, HasSubstr("takes the placed shape as stress-free would forget that"));
  EXPECT_THAT(narrow.err, HasSubstr("the pattern is too small for the body: to lie round it, half of panel \""));
}

}  // namespace
}  // namespace toile::test
