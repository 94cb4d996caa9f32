// Pressure and tension at levels: sections that are cut across the fabric's directions, several at one level, layers,
// open ones, and levels beside the garment. A sleeve of isotropic fabric, 250 mm wide, on a cylinder of radius 60 mm:
// the closed form has a tension of 0.0656 N/mm and a pressure of 1.0931 kPa, on 40 elements around 0.0654 N/mm, 1.0901
// kPa.
#include <cmath>
#include <map>
#include <sstream>

#include "app/exodus.hpp"
#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

/// Rows of a table by their first cell, then by column.
using Rows = std::map<std::string, std::map<std::string, std::string>>;

class Sections : public ProgramTest {
 protected:
  static std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
  }
  static std::string real(const std::string& name, double value) {
    return parameter(name, "double", std::to_string(value));
  }
  static std::string list(const std::string& name, const std::string& content) {
    return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
  }

  static std::string sleeve(const std::string& name, double wale, const std::string& axis, double offset,
                            double angle) {
    return list(name, parameter("material", "string", "fabric") + parameter("shape", "string", "rectangle") +
                          real("width", 250.0) + real("height", 100.0) + parameter("elements across", "int", "40") +
                          parameter("elements along", "int", "10") + real("wale angle", wale) +
                          list("Placement", parameter("type", "string", "wrap") +
                                                parameter("axis bottom", "Array(double)", "{" + axis + ", 0, 0}") +
                                                parameter("axis top", "Array(double)", "{" + axis + ", 0, 1}") +
                                                real("from", 60.0) + real("to", 150.0) + real("coverage", 0.97) +
                                                real("offset", offset) + real("angle", angle)));
  }

  /// A scene with the panels of these names. `output`: what stands in Output beside the level "middle".
  void write_sleeves(const std::string& body, const std::string& panels, const std::vector<std::string>& names,
                     const std::string& output = "", const std::string& more = "") const {
    std::string seams, bottoms;
    for (const std::string& name : names) {
      seams += "<ParameterList name=\"" + name + " side\"><Parameter name=\"first\" type=\"string\" value=\"" + name +
               ".left\"/><Parameter name=\"second\" type=\"string\" value=\"" + name + ".right\"/></ParameterList>";
      bottoms += (bottoms.empty() ? "" : ", ") + name + ".bottom";
    }
    const std::string sew = list("sew", parameter("type", "string", "sew") + list("Damping", "")),
                      settle = list("settle", parameter("type", "string", "settle"));
    write(
        "scene.xml",
        list("scene",
             list("Body", body) +
                 list("Materials", list("fabric", parameter("type", "string", "neo-hookean") + real("C10", 0.05) +
                                                      real("thickness", 0.5))) +
                 list("Panels", panels) + list("Seams", seams) +
                 list("Supports", list("lower end", parameter("on", "Array(string)", "{" + bottoms + "}") +
                                                        parameter("hold", "string", "z"))) +
                 list("Contact", parameter("contact surface", "string", "mid-surface")) + list("Stages", sew + settle) +
                 list("Output", output + list("Levels", list("middle", parameter("height", "double", "100")))) + more));
  }
  void write_one(double wale, const std::string& output = "", const std::string& more = "") const {
    write_sleeves(cylinder, sleeve("sleeve", wale, "0", 0.3, 0.0), {"sleeve"}, output, more);
  }

  Rows rows(const std::string& file) const {
    std::istringstream text(read(file));
    const auto cells = [](const std::string& line) {
      std::vector<std::string> found;
      std::istringstream stream(line);
      for (std::string cell; std::getline(stream, cell, ',');) found.push_back(cell);
      return found;
    };
    std::string line;
    std::getline(text, line);
    const std::vector<std::string> names = cells(line);
    Rows all;
    while (std::getline(text, line)) {
      const std::vector<std::string> row = cells(line);
      for (size_t c = 0; c < row.size(); ++c) all[row[0]][names[c]] = row[c];
    }
    return all;
  }
  Rows levels() const { return rows("out/pressure-levels.csv"); }

  static constexpr const char* cylinder =
      R"(<Parameter name="type" type="string" value="cylinder"/><Parameter name="radius" type="double" value="60"/>)";
};

double value(const Rows& rows, const std::string& row, const std::string& column) {
  return std::stod(rows.at(row).at(column));
}

void expect_one_layer(const Rows& rows, const std::string& row) {
  EXPECT_NEAR(value(rows, row, "mean pressure [kPa]"), 1.0901, 0.005) << row;
  EXPECT_NEAR(value(rows, row, "hoop tension T [N/mm]"), 0.0654, 0.0001) << row;
  EXPECT_NEAR(value(rows, row, "Laplace T/r [kPa]"), 1.091, 0.002) << row;
  EXPECT_NEAR(value(rows, row, "girth [mm]"), 376.6, 0.1) << row;
  EXPECT_EQ(rows.at(row).at("closed"), "1") << row;
}

// An isotropic fabric does not know its wale: hoop tension, Laplace's value and pressure are the same at every angle.
TEST_F(Sections, TensionIsThatAcrossTheCut) {
  for (const double wale : {0.0, 45.0, 90.0}) {
    write_one(wale);
    const Outcome run = toile("run scene.xml --output out");
    ASSERT_EQ(run.status, 0) << run.err;
    expect_one_layer(levels(), "middle");
  }
}

// Two layers: a row each, and their sum, which is what the skin feels, at the level and on the body.
TEST_F(Sections, LayersAddUp) {
  write_sleeves(cylinder, sleeve("inner", 90.0, "0", 0.3, 0.0) + sleeve("outer", 90.0, "0", 2.0, 180.0),
                {"inner", "outer"});
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  const Rows found = levels();
  expect_one_layer(found, "middle (1)");
  expect_one_layer(found, "middle (2)");
  EXPECT_EQ(found.at("middle (1)").at("panels"), "inner");
  EXPECT_NEAR(value(found, "middle (1+2)", "mean pressure [kPa]"), 2.0 * 1.0901, 0.01);
  EXPECT_NEAR(value(found, "middle (1+2)", "Laplace T/r [kPa]"), 2.0 * 1.091, 0.004);
  EXPECT_NEAR(value(found, "middle (1+2)", "girth [mm]"), 376.6, 0.1);
  EXPECT_THAT(run.out, HasSubstr("middle (1+2)"));
  const ExodusStep result(path("out/results.exo"));
  const std::vector<double> pressure = result.nodal("pressure");
  constexpr size_t garment = 2 * 41 * 11;  // nodes, the body's behind them
  int skin = 0;
  for (size_t n = garment; n < pressure.size(); ++n) {
    if (std::abs(result.position[2][n] - 100.0) > 20.0) continue;
    EXPECT_NEAR(pressure[n], 2.0 * 1.0901, 0.01) << n;
    ++skin;
  }
  EXPECT_GT(skin, 100);
}

// Two legs: a row each with the girth of one, and a curve that is not empty.
TEST_F(Sections, LegsHaveARowEach) {
  std::ostringstream body;  // two tubes, 200 mm apart
  for (int leg = 0; leg < 2; ++leg)
    for (int ring = 0; ring <= 60; ++ring)
      for (int k = 0; k < 72; ++k)
        body << "v " << (leg == 0 ? -100.0 : 100.0) + 60.0 * std::cos(2.0 * M_PI * k / 72) << " "
             << 60.0 * std::sin(2.0 * M_PI * k / 72) << " " << -50.0 + 5.0 * ring << "\n";
  for (int leg = 0; leg < 2; ++leg)
    for (int ring = 0; ring < 60; ++ring)
      for (int k = 0; k < 72; ++k) {
        const int first = leg * 61 * 72 + ring * 72 + 1, a = first + k, b = first + (k + 1) % 72;
        body << "f " << a << " " << b << " " << b + 72 << "\nf " << a << " " << b + 72 << " " << a + 72 << "\n";
      }
  write("legs.obj", body.str());
  write_sleeves(R"(<Parameter name="type" type="string" value="file"/>
                   <Parameter name="file" type="string" value="legs.obj"/>
                   <Parameter name="closed" type="bool" value="false"/><ParameterList name="Reach">
                   <Parameter name="bottom" type="double" value="40"/><Parameter name="top" type="double" value="170"/>
                   </ParameterList>)",
                sleeve("right", 90.0, "-100", 0.3, 0.0) + sleeve("left", 90.0, "100", 0.3, 0.0), {"right", "left"},
                R"(<Parameter name="stations" type="int" value="5"/>)");
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  const Rows found = levels();
  ASSERT_EQ(found.size(), 2u);
  expect_one_layer(found, "middle (1)");
  expect_one_layer(found, "middle (2)");
  EXPECT_EQ(found.at("middle (1)").at("panels"), "right");
  EXPECT_EQ(found.at("middle (2)").at("panels"), "left");
  const Rows curve = rows("out/pressure-curve.csv");
  EXPECT_EQ(curve.size(), 2u) << "sections 1 and 2";
}

// A level that the garment does not reach has no values, not a girth of 0, and is told.
TEST_F(Sections, BesideTheGarmentAreEmpty) {
  write_one(90.0);
  std::string text = read("scene.xml");
  text.replace(text.find("value=\"100\"/></ParameterList></ParameterList></ParameterList>"), 11, "value=\"400\"");
  write("scene.xml", text);
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err,
              HasSubstr("level \"middle\" at the height 400 mm does not meet the garment, which lies between 60"));
  EXPECT_EQ(levels().at("middle").at("girth [mm]"), "");
  EXPECT_THAT(run.out, HasSubstr("not reached"));
}

// A level that cuts the upper edge of the garment, here because the axis is inclined by 0.3, cuts an open piece of
// fabric: marked, without radius and Laplace's value, and told. The level in the middle is closed.
TEST_F(Sections, ThatAreCutInPartAreOpen) {
  write_one(90.0, parameter("axis direction", "Array(double)", "{0.3, 0, 1}"));
  std::string text = read("scene.xml");
  const std::string one = list("middle", parameter("height", "double", "100"));
  text.replace(text.find(one), one.size(), one + list("upper", parameter("height", "double", "130")));
  write("scene.xml", text);
  const Outcome run = toile("run scene.xml --output out");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("level \"upper\" at the height 130 mm cuts "));
  EXPECT_THAT(run.err, HasSubstr(" of fabric (sleeve) that does not close round the body"));
  const Rows found = levels();
  EXPECT_EQ(found.at("middle").at("closed"), "1");
  EXPECT_EQ(found.at("upper").at("closed"), "0");
  EXPECT_EQ(found.at("upper").at("Laplace T/r [kPa]"), "");
  EXPECT_LT(value(found, "upper", "girth [mm]"), 376.0);
}

// Checks know the pressure at a level and the ratio of two; a level that does not exist is refused by its nearest name.
TEST_F(Sections, AreChecked) {
  const auto checks = [](const std::string& quantity, double lower, double upper) {
    std::ostringstream text;
    text
        << R"(<ParameterList name="Checks"><ParameterList name="class"><Parameter name="quantity" type="string" value=")"
        << quantity << "\"/><Parameter name=\"lower\" type=\"double\" value=\"" << lower
        << "\"/><Parameter name=\"upper\" type=\"double\" value=\"" << upper << "\"/></ParameterList></ParameterList>";
    return text.str();
  };
  write_one(90.0, "", checks("pressure at level middle", 1.08, 1.10));
  EXPECT_EQ(toile("run scene.xml --output out").status, 0);
  write_one(90.0, "", checks("pressure at level middle", 1.2, 1.3));
  const Outcome low = toile("run scene.xml --output out");
  EXPECT_EQ(low.status, 4);
  EXPECT_THAT(low.err, HasSubstr("check \"class\" does not hold: pressure at level middle is 1.09"));
  write_one(90.0, "", checks("ratio of levels middle to middle", 0.999, 1.001));
  EXPECT_EQ(toile("run scene.xml --output out").status, 0);
  write_one(90.0, "", checks("pressure at level midle", 0.0, 1.0));
  const Outcome unknown = toile("check scene.xml");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("no level is named \"midle\"; did you mean \"middle\"?"));
}

}  // namespace
}  // namespace toile::test
