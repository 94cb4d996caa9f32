// Half a garment, held in its plane of symmetry.
#include <cmath>
#include <sstream>
#include <vector>

#include "app/program.hpp"
#include "cases/line_stations.hpp"

namespace toile::test {
namespace {

/// Half a tube of 200 mm on a cylinder of radius 50 mm, its sides held in the plane y = 0.
std::string half_tube() {
  return R"xml(<ParameterList name="scene">
  <ParameterList name="Body">
    <Parameter name="type" type="string" value="cylinder"/><Parameter name="radius" type="double" value="50"/>
  </ParameterList>
  <ParameterList name="Materials"><ParameterList name="soft">
    <Parameter name="type" type="string" value="neo-hookean"/><Parameter name="C10" type="double" value="0.05"/>
    <Parameter name="thickness" type="double" value="0.5"/>
  </ParameterList></ParameterList>
  <ParameterList name="Contact"><Parameter name="contact surface" type="string" value="mid-surface"/></ParameterList>
  <ParameterList name="Panels"><ParameterList name="tube">
    <Parameter name="material" type="string" value="soft"/>
    <Parameter name="shape" type="string" value="rectangle"/>
    <Parameter name="width" type="double" value="100"/> <Parameter name="height" type="double" value="60"/>
    <Parameter name="elements across" type="int" value="20"/> <Parameter name="elements along" type="int" value="9"/>
    <ParameterList name="Placement">
      <Parameter name="type" type="string" value="wrap"/>
      <Parameter name="axis bottom" type="Array(double)" value="{0, 0, 0}"/>
      <Parameter name="axis top" type="Array(double)" value="{0, 0, 1}"/>
      <Parameter name="from" type="double" value="0"/> <Parameter name="to" type="double" value="60"/>
      <Parameter name="angle" type="double" value="90"/> <Parameter name="coverage" type="double" value="0.5"/>
    </ParameterList>
  </ParameterList></ParameterList>
  <ParameterList name="Supports"><ParameterList name="hem">
    <Parameter name="on" type="Array(string)" value="{tube.bottom}"/> <Parameter name="hold" type="string" value="z"/>
  </ParameterList><ParameterList name="middle">
    <Parameter name="on" type="Array(string)" value="{tube.left, tube.right}"/>
    <Parameter name="hold" type="string" value="y"/>
  </ParameterList></ParameterList>
  <ParameterList name="Stages"><ParameterList name="settle">
    <Parameter name="type" type="string" value="settle"/>
  </ParameterList></ParameterList>
  <ParameterList name="Output"><ParameterList name="Levels">
    <ParameterList name="C"><Parameter name="height" type="double" value="25"/></ParameterList>
  </ParameterList></ParameterList>
</ParameterList>)xml";
}

class Half : public ProgramTest {};

// The level of half a tube is that of the whole one, with its girth and Laplace's pressure, and its middle is told to
// be neither open nor at a support.
TEST_F(Half, HasTheLevelsOfTheWhole) {
  write("scene.xml", half_tube());
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, ::testing::HasSubstr("half, with its mirror image"));
  EXPECT_EQ(run.err.find("does not close"), std::string::npos) << run.err;
  std::istringstream csv(read("out/pressure-levels.csv"));
  std::string line, cell;
  std::getline(csv, line);
  std::getline(csv, line);
  std::vector<std::string> cells;
  for (std::istringstream row(line); std::getline(row, cell, ',');) cells.push_back(cell);
  const double stretch = M_PI / 2.0;
  const double laplace = 2.0 * 0.05 * 0.5 * (stretch - 1.0 / (stretch * stretch)) * std::sqrt(stretch) / 50.0;  // MPa
  EXPECT_NEAR(std::stod(cells.at(2)), 1000.0 * laplace, 0.003 * 1000.0 * laplace);  // chords of 8 mm take 0.2 %
  EXPECT_NEAR(std::stod(cells.at(10)), 2.0 * M_PI * 50.0, 0.5);
}

// A line round the body and points of it tell beyond the plane of symmetry what its mirror image presses with.
TEST_F(Half, HasTheLinesAndPointsOfTheWhole) {
  std::string scene = half_tube();
  const std::string output = "<ParameterList name=\"Output\">";
  scene.insert(scene.find(output) + output.size(),
               R"xml(<ParameterList name="Lines"><ParameterList name="round">
    <Parameter name="type" type="string" value="level"/><Parameter name="height" type="double" value="25"/>
    <Parameter name="from" type="Array(double)" value="{0, 50, 25}"/>
    <Parameter name="stations" type="int" value="13"/></ParameterList></ParameterList>)xml");
  write("scene.xml", scene);
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<Station> line = line_stations(read("out/pressure-lines.csv"));
  ASSERT_EQ(line.size(), 13U);
  for (const Station& s : line) {
    EXPECT_GT(s.kpa, 0.0);
    EXPECT_NEAR(s.kpa, line.front().kpa, 1e-3 * line.front().kpa) << "y " << s.y;
  }
}

// A hem that is held at its height is no plane of symmetry: what lies beside it is told to be at a support.
TEST_F(Half, AHeldHemIsASupport) {
  std::string scene = half_tube();
  const std::string height = R"(name="height" type="double" value="25")";
  scene.replace(scene.find(height), height.size(), R"(name="height" type="double" value="3")");
  write("scene.xml", scene);
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, ::testing::HasSubstr("half, with its mirror image, at a support"));
}

}  // namespace
}  // namespace toile::test
