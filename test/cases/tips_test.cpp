// A sheet drawn over a tip, on which the pressure has no limit as the elements shrink: none is told as if it had one.
#include <gmock/gmock.h>

#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Tips : public ProgramTest {
 protected:
  /// A sheet of n x n elements, with its middle at `middle` mm beside the tip of the body in a file of
  /// input/stability.
  Outcome run(const std::string& body, int n, double middle = 0.0) const {
    const std::string folder = TOILE_SOURCE_DIR "/input/stability/", count = std::to_string(n);
    std::ostringstream scene;
    scene << R"x(<ParameterList name="scene">
  <Parameter name="include" type="Array(string)" value="{)x"
          << folder << "sheet-on-tip.xml, " << folder << body << R"x(}"/>
  <ParameterList name="Panels"><ParameterList name="sheet">
    <Parameter name="elements across" type="int" value=")x"
          << count << R"x("/>
    <Parameter name="elements along" type="int" value=")x"
          << count << R"x("/>
    <ParameterList name="Placement">
      <Parameter name="origin" type="Array(double)" value="{)x"
          << middle - 50.0 << R"x(, -50, 61}"/>
    </ParameterList>
  </ParameterList></ParameterList>
</ParameterList>)x";
    write("scene.xml", scene.str());
    return toile("run scene.xml --output results");
  }
};

// Of a blunt tip between, on and beside nodes, on meshes on which nothing warns too, the largest pressure has an error
// as large as itself, where a few hundredths were told.
TEST_F(Tips, PressureHasNoLimit) {
  for (const auto& [n, middle] : {std::pair(25, 0.0), std::pair(36, 0.0), std::pair(36, 0.7)}) {
    SCOPED_TRACE(std::to_string(n) + " elements, " + std::to_string(middle) + " mm beside");
    const Outcome outcome = run("tip-60-degrees.xml", n, middle);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    std::istringstream text(outcome.out.substr(outcome.out.find("Largest pressure away from supports:")));
    std::string word;
    double pressure = 0.0, error = 0.0;
    for (int i = 0; i < 5; ++i) text >> word;
    text >> pressure >> word >> error;
    EXPECT_GT(pressure, 5.0);
    EXPECT_GE(error, 0.9 * pressure);
  }
}

// A tip that goes through an element, so that no or few nodes touch the body, is refused with all results written; a
// blunt tip on a node is not.
TEST_F(Tips, ThroughAnElementIsRefused) {
  for (const int n : {7, 24}) {
    SCOPED_TRACE(n);
    const Outcome outcome = run("tip-15-degrees.xml", n);
    EXPECT_EQ(outcome.status, 4);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("the body goes through "), HasSubstr("the elements do not see the body: "),
                                   HasSubstr(" mm, 1.00 times their side, and at most 0.5 is allowed")));
    EXPECT_TRUE(exists("results/results.exo"));
    EXPECT_TRUE(exists("results/body-force.csv"));
  }
  const Outcome blunt = run("tip-60-degrees.xml", 24);
  EXPECT_EQ(blunt.status, 0);
  EXPECT_THAT(blunt.err, Not(HasSubstr("do not see the body")));
}

// What the body carries over a blunt tip is told with an error that covers the true one, and falls with the elements.
TEST_F(Tips, ForceHasAnError) {
  constexpr double exact = 1.552;  // N: free meshes of 0.25 mm at the tip, input/stability/tips.csv
  double before = exact;
  for (const int n : {13, 25, 49}) {
    SCOPED_TRACE(n);
    ASSERT_EQ(run("tip-60-degrees.xml", n).status, 0);
    const std::vector<std::string> z = last_row(read("results/body-force.csv"));
    ASSERT_EQ(z.size(), 3u);
    const double force = std::stod(z[1]), error = std::stod(z[2]);
    EXPECT_NEAR(force, exact, std::min(error, 0.03 * exact));
    EXPECT_LT(error, 0.8 * before);
    before = error;
  }
}

}  // namespace
}  // namespace toile::test
