// The list "Testers": what testers of a hosiery laboratory would read.
#include <cmath>

#include "app/program.hpp"
#include "toile/base/csv_file.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

class Testers : public ProgramTest {
 protected:
  /// Of a table, as text: the value of the first row.
  double first(const std::string& file, const std::string& column, const std::string& unit) const {
    const base::CsvFile table = base::read_csv(path(file), "point");
    for (const base::CsvColumn& one : table.columns)
      if (one.name == column && one.unit == unit) return base::numbers(table, one).at(0);
    throw std::runtime_error("no column " + column);
  }
};

const std::string levels = "<ParameterList name=\"Levels\">";
const std::string sensor = R"(<ParameterList name="Testers"><ParameterList name="sensor">
  <Parameter name="type" type="string" value="rigid sensor"/><Parameter name="level" type="string" value="middle"/>
  <Parameter name="width" type="double" value="20"/><Parameter name="height" type="double" value="1"/>
  </ParameterList></ParameterList>)";

// Flat jaws that stretch a sleeve's fabric as a cylinder of 60 mm does, along it as well, read what it presses with
// there.
TEST_F(Testers, JawsReadThePressureOnACylinder) {
  write_scene("sleeve", {{levels, sensor + levels}});
  const Outcome worn = toile("run scene.xml --output worn");
  ASSERT_EQ(worn.status, 0) << worn.err;
  const double pressure = first("worn/pressure-levels.csv", "mean pressure", "kPa"),
               error = first("worn/pressure-levels.csv", "error of the mean pressure", "kPa");
  const Outcome pulled = toile("run " TOILE_SOURCE_DIR "/test/app/scenes/jaws.xml --output jaws");
  ASSERT_EQ(pulled.status, 0) << pulled.err;
  EXPECT_NEAR(first("jaws/testers.csv", "reading", "kPa"), pressure, 1.1 * error);
  EXPECT_LT(error, 0.03 * pressure);
  // 2 R sin(beta) / b = 2.366 at R = 60, b = 20, h = 1 mm.
  EXPECT_NEAR(first("worn/testers.csv", "reading", "kPa"), 2.366 * pressure, 0.02 * 2.366 * pressure);
}

// A sensor that is wider than the limb, or lies where no fabric is, reads nothing, and a warning says why.
TEST_F(Testers, WithoutAReadingSayWhy) {
  std::string wide = sensor;
  wide.replace(wide.find("value=\"20\""), 10, "value=\"150\"");
  write_scene("sleeve", {{levels, wide + levels}});
  EXPECT_THAT(toile("run scene.xml --output out").err,
              HasSubstr("tester \"sensor\" reads nothing: the sensor is wider than the limb"));
  write_scene("sleeve", {{levels, sensor + levels}, {"value=\"65\"", "value=\"300\""}});
  EXPECT_THAT(toile("run scene.xml --output out").err,
              HasSubstr("tester \"sensor\" reads nothing: no fabric reaches level \"middle\""));
}

// A tester at a level that is not there is refused with the nearest name.
TEST_F(Testers, NeedTheirLevel) {
  std::string other = sensor;
  other.replace(other.find("\"middle\""), 8, "\"midle\"");
  write_scene("sleeve", {{levels, other + levels}});
  const Outcome outcome = toile("check scene.xml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("scene > Output > Testers > sensor: parameter \"level\" = \"midle\""));
  EXPECT_THAT(outcome.err, HasSubstr("did you mean \"middle\"?"));
}

}  // namespace
}  // namespace toile::test
