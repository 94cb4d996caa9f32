// The list "Drapemeter": drape coefficient and folds of a hanging fabric.
#include "app/program.hpp"
#include "toile/base/csv_file.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

class Drapemeter : public ProgramTest {
 protected:
  /// The shipped cotton on a coarse mesh, with so much of its weight and a check of its coefficient.
  Outcome hang(double weight, double least) const {
    const std::string cotton = TOILE_SOURCE_DIR "/input/benchmarks/drape-cotton.xml";
    write("scene.xml", R"xml(<ParameterList name="scene">
      <Parameter name="include" type="Array(string)" value="{)xml" +
                           cotton + R"xml(}"/>
      <Parameter name="finer" type="double" value="0.4"/>
      <ParameterList name="Stages"><ParameterList name="hang">
        <Parameter name="target" type="double" value=")xml" +
                           std::to_string(weight) + R"xml("/>
      </ParameterList></ParameterList>
      <ParameterList name="Checks"><ParameterList name="drape">
        <Parameter name="quantity" type="string" value="drape coefficient"/>
        <Parameter name="lower" type="double" value=")xml" +
                           std::to_string(least) + R"xml("/>
      </ParameterList></ParameterList></ParameterList>)xml");
    return toile("run scene.xml --output out");
  }
  double number(const std::string& file, const std::string& column, size_t row = 0) const {
    const base::CsvFile table = base::read_csv(path(file), "row");
    for (const base::CsvColumn& one : table.columns)
      if (one.name == column) return base::numbers(table, one).at(row);
    throw std::runtime_error("no column " + column);
  }
};

// Fabric of a thousandth of its weight stays flat: coefficient 1 but for the facets of the rim, no folds, and a round
// shadow.
TEST_F(Drapemeter, TellsThatALightFabricStaysFlat) {
  const Outcome outcome = hang(1e-3, 0.98);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("drape coefficient 0.99"));
  EXPECT_NEAR(number("out/drape.csv", "drape coefficient"), 1.0, 0.01);
  EXPECT_EQ(number("out/drape.csv", "folds"), 0.0);
  for (const size_t quarter : {0, 1, 2, 3}) EXPECT_NEAR(number("out/shadow.csv", "radius", 360 * quarter), 150.0, 0.5);
}

// A shadow is told of a fabric whose middle the light's axis goes through, across it: 3 mm beside it or aslant there is
// none.
TEST_F(Drapemeter, RefusesAnAxisBesideTheMiddle) {
  for (const std::string axis : {R"x("axis point" type="Array(double)" value="{3, 0, 0})x",
                                 R"x("axis direction" type="Array(double)" value="{0.1, 0, 1})x"}) {
    write("beside.xml", R"xml(<ParameterList name="scene">
      <Parameter name="include" type="Array(string)" value="{)xml" TOILE_SOURCE_DIR
                        R"xml(/input/benchmarks/drape-cotton.xml}"/>
      <ParameterList name="Output"><Parameter name=)xml" +
                            axis + R"xml("/></ParameterList></ParameterList>)xml");
    const Outcome outcome = toile("check beside.xml");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("scene > Output > Drapemeter"));
    EXPECT_THAT(outcome.err, HasSubstr("axis of \"Output\""));
  }
}

// A coefficient that a check does not allow ends the run with status 4.
TEST_F(Drapemeter, IsChecked) {
  const Outcome outcome = hang(0.5, 0.98);
  EXPECT_EQ(outcome.status, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("check \"drape\" does not hold: drape coefficient is 0."));
}

}  // namespace
}  // namespace toile::test
