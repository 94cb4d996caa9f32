#include <cmath>
#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;

class Mannequin : public ProgramTest {
 protected:
  /// Number behind the name at the start of a line of a table; nan if there is none.
  static double in_table(const std::string& table, const std::string& name, int column) {
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);)
      if (line.rfind(name + "  ", 0) == 0) {
        std::istringstream cells(line.substr(name.size()));
        double value = std::nan("");
        for (int i = 0; i <= column; ++i) cells >> value;
        return value;
      }
    return std::nan("");
  }
  /// Makes a mannequin, and expects the girths (cm) that `body landmarks` finds on its file within 1 %.
  void expect_girths(const std::string& options, const std::vector<std::pair<std::string, double>>& girths) {
    const Outcome made = toile("body make --output body.obj --edge 14 " + options);
    ASSERT_EQ(made.status, 0) << made.err;
    const Outcome found = toile("body landmarks body.obj");
    ASSERT_EQ(found.status, 0) << found.err;
    for (const auto& [name, girth] : girths) {
      SCOPED_TRACE(options + ": " + name);
      EXPECT_NEAR(in_table(found.out, name, 4) / girth, 1.0, 0.01);
    }
  }
};

// Without a measurement it is the default body: closed, one piece, and every girth within 1 %.
TEST_F(Mannequin, Default) {
  expect_girths("", {{"neck", 31.0},
                     {"bust", 83.0},
                     {"underbust", 71.5},
                     {"waist", 64.0},
                     {"hip", 90.0},
                     {"left thigh", 52.0},
                     {"right thigh", 52.0},
                     {"left knee", 33.0},
                     {"left calf", 34.0},
                     {"right calf", 34.0},
                     {"left ankle", 20.5},
                     {"left upper arm", 25.5},
                     {"right wrist", 15.0}});
  const Outcome measured = toile("body measure body.obj --length 'left shoulder' 'right shoulder'");
  EXPECT_EQ(measured.status, 0) << measured.err;
  EXPECT_EQ(measured.err, "");  // nothing had to be repaired, no facets intersect
  EXPECT_THAT(measured.out, HasSubstr("pieces     1\n"));
  EXPECT_NEAR(in_table(measured.out, "left shoulder to right shoulder", 1) / 37.0, 1.0, 0.01);
}

// Other sizes are reached as well, and what is not given follows what is.
TEST_F(Mannequin, OtherSizes) {
  expect_girths("--bust 100 --waist 84 --hip 108", {{"bust", 100.0},
                                                    {"underbust", 71.5 / 83.0 * 100.0},
                                                    {"waist", 84.0},
                                                    {"hip", 108.0},
                                                    {"left thigh", 52.0 * 1.2}});
  expect_girths("--height 148 --bust 76 --waist 58 --hip 82", {{"bust", 76.0}, {"waist", 58.0}, {"hip", 82.0}});
  expect_girths("--height 172 --bust 92 --waist 70 --hip 98 --knee 35 --wrist 16",
                {{"bust", 92.0}, {"waist", 70.0}, {"hip", 98.0}, {"left knee", 35.0}, {"left wrist", 16.0}});
}

// Arms are turned to the angle that is asked for, and the girths are reached there too.
TEST_F(Mannequin, Arms) {
  expect_girths("--arms 30", {{"bust", 83.0}, {"waist", 64.0}, {"left upper arm", 25.5}, {"right upper arm", 25.5}});
  const Outcome found = toile("body landmarks body.obj");
  const double x = in_table(found.out, "left elbow", 0) - in_table(found.out, "left upper arm", 0);
  const double z = in_table(found.out, "left elbow", 2) - in_table(found.out, "left upper arm", 2);
  EXPECT_NEAR(std::atan2(-z, x) * 180.0 / M_PI, 30.0, 3.0);
}

// Measurements that no body has, or that contradict each other, and arms that would touch are refused with the reason,
// and nothing is written.
TEST_F(Mannequin, Refusals) {
  const auto expect = [this](const std::string& options, const std::string& message) {
    const Outcome outcome = toile("body make --edge 14 " + options);
    EXPECT_EQ(outcome.status, 2) << options;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_FALSE(exists("mannequin.obj"));
  };
  expect("--waist 200 --hip 60", "waist 200 cm (given): no body of 158 cm has it; allowed are 32 cm to 140.8 cm");
  expect("--waist 100",
         "waist 100 cm and hip 90 cm contradict each other: the waist is the smallest girth between hip "
         "and armpits; with this hip the waist is at most 88.2 cm");
  expect("--thigh 70", "thigh 70 cm and hip 90 cm contradict each other: two thighs have to fit below the hip");
  expect("--height 15.8", "height 15.8 cm: allowed are 100 cm to 230 cm");
  expect("--bust nan", "bust");
  expect("--arms 2", "the arms cannot be held 2 degrees below the level");
  expect("--arms 84", "the surface would pass through itself");
  expect("--output body.stl", "the file is written as OBJ, so its name ends in .obj");
  expect("--wiast 60", "unknown option of \"toile body make\" \"--wiast\"; did you mean \"--waist\"?");
}

// A scene may have a mannequin as its body: the one that the command makes of the same measurements, with its
// landmarks. What contradicts itself is refused where it stands.
TEST_F(Mannequin, OfAScene) {
  const auto checked = [this](const std::string& body) {
    write("scene.xml", R"xml(<ParameterList name="scene"><ParameterList name="Body">)xml" + body +
                           R"xml(<Parameter name="cell" type="double" value="20"/></ParameterList>
      <ParameterList name="Materials"><ParameterList name="knit"><Parameter name="type" type="string" value="rebar"/>
        <Parameter name="set" type="string" value="pantyhose"/></ParameterList></ParameterList>
      <ParameterList name="Panels"><ParameterList name="band"><Parameter name="material" type="string" value="knit"/>
        <Parameter name="shape" type="string" value="rectangle"/>
        <Parameter name="width" type="double" value="500"/><Parameter name="height" type="double" value="60"/>
        <Parameter name="elements across" type="int" value="24"/><Parameter name="elements along" type="int" value="3"/>
        <ParameterList name="Placement"><Parameter name="type" type="string" value="wrap"/>
          <Parameter name="axis bottom" type="Array(double)" value="{0, -30, 0}"/>
          <Parameter name="axis top" type="Array(double)" value="{0, -30, 1}"/>
          <Parameter name="from" type="string" value="waist - 40"/>
          <Parameter name="to" type="string" value="waist + 20"/>
          <Parameter name="coverage" type="double" value="0.95"/></ParameterList></ParameterList></ParameterList>
      <ParameterList name="Seams"><ParameterList name="side"><Parameter name="first" type="string" value="band.left"/>
        <Parameter name="second" type="string" value="band.right"/></ParameterList></ParameterList>
      <ParameterList name="Stages"><ParameterList name="sew"><Parameter name="type" type="string" value="sew"/>
        <ParameterList name="Damping"/></ParameterList></ParameterList></ParameterList>)xml");
    return toile("check scene.xml");
  };
  const auto surface = [](const std::string& text) {
    const std::size_t from = text.find("triangles in reach");
    EXPECT_NE(from, std::string::npos) << text;
    return text.substr(from, text.find(", fitted in", from) - from);
  };
  const std::string waist = R"(<Parameter name="waist" type="double" value=")";
  const Outcome own = checked(R"(<Parameter name="type" type="string" value="mannequin"/>)" + waist +
                              R"(660"/><Parameter name="edge" type="double" value="14"/>)");
  ASSERT_EQ(own.status, 0) << own.err;
  EXPECT_THAT(own.out, HasSubstr("mannequin (height 1580, bust 830, waist 660, hip 900)"));
  ASSERT_EQ(toile("body make --waist 66 --edge 14 --output form.obj").status, 0);
  const Outcome file = checked(R"(<Parameter name="type" type="string" value="file"/>)"
                               R"(<Parameter name="file" type="string" value="form.obj"/>)");
  ASSERT_EQ(file.status, 0) << file.err;
  EXPECT_EQ(surface(own.out), surface(file.out));
  const Outcome wide = checked(R"(<Parameter name="type" type="string" value="mannequin"/>)" + waist + R"(950"/>)");
  EXPECT_EQ(wide.status, 2);
  EXPECT_THAT(wide.err, AllOf(HasSubstr("scene.xml: scene > Body: parameter \"waist\" = 950: "),
                              HasSubstr("waist 95 cm and hip 90 cm contradict each other")));
}

}  // namespace
}  // namespace toile::test
