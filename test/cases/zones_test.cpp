// Zones of another fabric.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

constexpr double radius = 50.0, girth = 200.0, soft = 0.5, firm = 1.5;  // mm; thickness of the fabrics

/// A tube on a cylinder, of one fabric but for a band that is three times as thick.
std::string tube() {
  return R"xml(<ParameterList name="scene">
  <ParameterList name="Body">
    <Parameter name="type" type="string" value="cylinder"/><Parameter name="radius" type="double" value="50"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="soft">
      <Parameter name="type" type="string" value="neo-hookean"/><Parameter name="C10" type="double" value="0.05"/>
      <Parameter name="thickness" type="double" value="0.5"/>
    </ParameterList>
    <ParameterList name="firm">
      <Parameter name="type" type="string" value="neo-hookean"/><Parameter name="C10" type="double" value="0.05"/>
      <Parameter name="thickness" type="double" value="1.5"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Contact"><Parameter name="contact surface" type="string" value="mid-surface"/></ParameterList>
  <ParameterList name="Panels"><ParameterList name="tube">
    <Parameter name="material" type="string" value="soft"/>
    <Parameter name="shape" type="string" value="rectangle"/>
    <Parameter name="width" type="double" value="200"/> <Parameter name="height" type="double" value="120"/>
    <Parameter name="mesher" type="string" value="free"/> <Parameter name="element size" type="double" value="7"/>
    <ParameterList name="Placement">
      <Parameter name="type" type="string" value="wrap"/>
      <Parameter name="axis bottom" type="Array(double)" value="{0, 0, 0}"/>
      <Parameter name="axis top" type="Array(double)" value="{0, 0, 1}"/>
      <Parameter name="from" type="double" value="0"/> <Parameter name="to" type="double" value="120"/>
      <Parameter name="coverage" type="double" value="1"/>
    </ParameterList>
    <ParameterList name="Zones"><ParameterList name="band">
      <Parameter name="band" type="Array(double)" value="{40, 80}"/>
      <Parameter name="material" type="string" value="firm"/>
    </ParameterList></ParameterList>
  </ParameterList></ParameterList>
  <ParameterList name="Seams"><ParameterList name="back">
    <Parameter name="first" type="string" value="tube.left"/> <Parameter name="second" type="string" value="tube.right"/>
  </ParameterList></ParameterList>
  <ParameterList name="Supports"><ParameterList name="hem">
    <Parameter name="on" type="Array(string)" value="{tube.bottom}"/> <Parameter name="hold" type="string" value="z"/>
  </ParameterList><ParameterList name="corner">
    <Parameter name="on" type="Array(string)" value="{tube.bottom-left}"/> <Parameter name="hold" type="string" value="xy"/>
  </ParameterList></ParameterList>
  <ParameterList name="Stages"><ParameterList name="settle">
    <Parameter name="type" type="string" value="settle"/>
  </ParameterList></ParameterList>
  <ParameterList name="Output"><ParameterList name="Points">
    <ParameterList name="below"><Parameter name="on" type="string" value="tube@(100 20)"/></ParameterList>
    <ParameterList name="band"><Parameter name="on" type="string" value="tube@(100 60)"/></ParameterList>
    <ParameterList name="above"><Parameter name="on" type="string" value="tube@(100 100)"/></ParameterList>
  </ParameterList><ParameterList name="Body points">
    <ParameterList name="under the band"><Parameter name="at" type="Array(double)" value="{0, -51, 48}"/></ParameterList>
    <ParameterList name="under the hem"><Parameter name="at" type="Array(double)" value="{0, -49, 16}"/></ParameterList>
    <ParameterList name="above all"><Parameter name="at" type="Array(double)" value="{0, -50, 300}"/></ParameterList>
  </ParameterList></ParameterList>
</ParameterList>)xml";
}

/// kPa, of a tube that is stretched round a cylinder and free along it: Laplace's law with the tension of a neo-Hookean
/// strip of C10 = 0.05 MPa over the length that it has become.
double laplace(double thickness) {
  const double stretch = 2.0 * M_PI * radius / girth;
  const double tension = 2.0 * 0.05 * thickness * (stretch - 1.0 / (stretch * stretch)) * std::sqrt(stretch);
  return 1000.0 * tension / radius;
}

class Zones : public ProgramTest {};

// Under a firm band the pressure is that of the firm fabric, beside it that of the soft one; so do points of the fabric
// and of the body tell. Both shrink alike along the tube, so nothing bends between them.
TEST_F(Zones, PressureIsThatOfTheFabricOfTheZone) {
  write("scene.xml", tube());
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  std::istringstream rows(read("out/pressure-points.csv"));
  std::map<std::string, double> pressure;
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    std::string name, cell;
    std::getline(cells, name, ',');
    for (int k = 0; k < 4; ++k) std::getline(cells, cell, ',');
    pressure[name] = std::stod(cell);
  }
  const double tolerance = 0.01;  // of the pressure; chords of 11 mm shorten the girth by 0.2 %, and take 0.5 % of it
  EXPECT_NEAR(pressure["band"], laplace(firm), tolerance * laplace(firm));
  EXPECT_NEAR(pressure["below"], laplace(soft), tolerance * laplace(soft));
  EXPECT_NEAR(pressure["under the band"], laplace(firm), tolerance * laplace(firm));
  EXPECT_NEAR(pressure["under the hem"], laplace(soft), tolerance * laplace(soft));
  EXPECT_EQ(pressure["above all"], 0.0);
  EXPECT_THAT(run.out, ::testing::HasSubstr("no fabric"));
  EXPECT_NEAR(pressure["above"], laplace(soft), tolerance * laplace(soft));
}

}  // namespace
}  // namespace toile::test
