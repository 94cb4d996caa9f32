// The shipped pantyhose from ankle to waist, on a coarse mesh.
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

/// The text with every `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}

/// Rows of a table by their first cell, then by column; a text is NaN.
std::map<std::string, std::map<std::string, double>> table(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<std::string> columns;
  for (std::istringstream head(line); std::getline(head, cell, ',');) columns.push_back(cell);
  std::map<std::string, std::map<std::string, double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string name;
    std::getline(cells, name, ',');
    for (std::size_t c = 1; c < columns.size() && std::getline(cells, cell, ','); ++c) {
      char* end = nullptr;
      const double value = std::strtod(cell.c_str(), &end);
      rows[name][columns[c]] = end == cell.c_str() ? std::nan("") : value;
    }
  }
  return rows;
}

class Pantyhose : public ProgramTest {
 protected:
  /// The shipped scene on a mesh of 16 mm.
  void write_coarse() const {
    std::ostringstream shipped;
    shipped << std::ifstream(TOILE_SOURCE_DIR "/input/pantyhose.xml").rdbuf();
    const std::string size = R"(name="element size" type="double" value=")";
    write("scene.xml",
          with(with(shipped.str(), size + "10\"", size + "16\""), "bodies/", TOILE_SOURCE_DIR "/input/bodies/"));
  }
};

// Legs, crotch seam and band close round the body and come to rest, and where the legs are round the pressure is the
// fabric's tension over the radius: at the thigh, which is straight along its axis, and, more by what the fabric's
// tension along the leg adds there, at the calf, which is convex. Both legs are alike; the band closes.
TEST_F(Pantyhose, LevelsAreLaplaces) {
  write_coarse();
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  auto levels = table(read("out/pressure-levels.csv"));
  const std::string pressure = "mean pressure [kPa]", laplace = "Laplace T/r [kPa]";
  for (const char* leg : {" (1)", " (2)"}) {
    auto thigh = levels["F" + std::string(leg)], calf = levels["C" + std::string(leg)];
    EXPECT_NEAR(thigh[pressure] / thigh[laplace], 1.0, 0.03) << leg;
    EXPECT_GT(calf[pressure] / calf[laplace], 1.0) << leg;
    EXPECT_LT(calf[pressure] / calf[laplace], 1.15) << leg;
  }
  for (const char* level : {"B1", "C", "D", "F", "G"}) {
    const std::string name(level);
    EXPECT_NEAR(levels[name + " (1)"][pressure] / levels[name + " (2)"][pressure], 1.0, 0.03) << name;
  }
  EXPECT_EQ(levels["T"]["closed"], 1.0);
  EXPECT_NEAR(levels["T"]["girth [mm]"], 642.0, 6.0);  // the waist of the body
}

// On a mannequin, too, they come to rest, with Laplace's pressure at the thigh, and its waist and hip have the girths
// that were asked for, at the levels that landmarks name.
TEST_F(Pantyhose, OnAMannequin) {
  const auto coarse = [](const std::string& panel) {
    return "<ParameterList name=\"" + panel + "\"><Parameter name=\"element size\" type=\"double\" value=\"16\"/>" +
           "</ParameterList>";
  };
  write("scene.xml", R"xml(<ParameterList name="scene">
      <Parameter name="include" type="Array(string)" value="{)xml" TOILE_SOURCE_DIR
                     R"xml(/input/pantyhose-mannequin.xml}"/>
      <ParameterList name="Body"><Parameter name="edge" type="double" value="22"/></ParameterList>
      <ParameterList name="Panels">)xml" +
                         coarse("left leg") + coarse("right leg") + coarse("band") +
                         "</ParameterList></ParameterList>");
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  auto levels = table(read("out/pressure-levels.csv"));
  const std::string pressure = "mean pressure [kPa]", laplace = "Laplace T/r [kPa]";
  for (const char* leg : {"F (1)", "F (2)"})
    EXPECT_NEAR(levels[leg][pressure] / levels[leg][laplace], 1.0, 0.04) << leg;
  EXPECT_NEAR(levels["T"]["girth [mm]"], 642.0, 6.0);
  EXPECT_NEAR(levels["H"]["girth [mm]"], 903.0, 9.0);
}

}  // namespace
}  // namespace toile::test
