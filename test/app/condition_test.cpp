// The condition number of the tangent, which a scene may ask for.
#include <cstdlib>

#include "app/program.hpp"

namespace toile::test {
namespace {

class Condition : public ProgramTest {
 protected:
  /// Of the fabric between flat jaws, on n x n elements.
  double number(int n) const {
    const std::string count = std::to_string(n);
    write("scene.xml", R"(<ParameterList name="scene">
      <Parameter name="include" type="Array)"
                       "(string)"
                       R"(" value="{)" TOILE_SOURCE_DIR R"(/input/testers/flat-jaws.xml}"/>
      <ParameterList name="Panels"><ParameterList name="band">
        <Parameter name="elements across" type="int" value=")" +
                           count + R"("/>
        <Parameter name="elements along" type="int" value=")" +
                           count + R"("/></ParameterList></ParameterList>
      <ParameterList name="Solver"><Parameter name="condition number" type="bool" value="true"/></ParameterList>
    </ParameterList>)");
    const Outcome outcome = toile("run scene.xml --output out");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string figures = read("out/figures.csv"), row = "condition number,";
    return std::atof(figures.substr(figures.find(row) + row.size()).c_str());
  }
};

// That of a membrane, a problem of second order, grows with the square of the number of elements.
TEST_F(Condition, GrowsWithTheSquareOfTheElements) {
  EXPECT_NEAR(number(20) / number(10), 4.0, 0.4);
  EXPECT_NEAR(number(40) / number(20), 4.0, 0.4);
}

}  // namespace
}  // namespace toile::test
