#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A band round the left thigh of the shipped body, whose places are landmarks or numbers.
class LandmarkScene : public ProgramTest {
 protected:
  static std::string word(const std::string& name, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"string\" value=\"" + value + "\"/>\n";
  }
  static std::string number(const std::string& name, double value) {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return "<Parameter name=\"" + name + "\" type=\"double\" value=\"" + text.str() + "\"/>\n";
  }
  static std::string array(const std::string& name, const std::string& type, const std::string& values) {
    return "<Parameter name=\"" + name + "\" type=\"Array(" + type + ")\" value=\"{" + values + "}\"/>\n";
  }
  static std::string list(const std::string& name, const std::string& content) {
    return "<ParameterList name=\"" + name + "\">\n" + content + "</ParameterList>\n";
  }
  void write_band(const std::string& heights, const std::string& axis, const std::string& level,
                  const std::string& output = "", const std::string& body = "") {
    const std::string file = TOILE_SOURCE_DIR "/input/bodies/female_body.obj";
    const std::string of_body = body.empty() ? word("type", "file") + word("file", file) : body;
    const std::string panel = word("material", "knit") + word("shape", "rectangle") + number("width", 420.0) +
                              number("height", 60.0) +
                              "<Parameter name=\"elements across\" type=\"int\" value=\"24\"/>\n"
                              "<Parameter name=\"elements along\" type=\"int\" value=\"4\"/>\n" +
                              list("Placement", word("type", "wrap") + axis + heights + number("coverage", 0.95));
    write("scene.xml",
          list("scene", list("Body", of_body) +
                            list("Materials", list("knit", word("type", "rebar") + word("set", "pantyhose"))) +
                            list("Panels", list("band", panel)) +
                            list("Seams", list("side", word("first", "band.left") + word("second", "band.right"))) +
                            list("Stages", list("sew", word("type", "sew") + list("Damping", ""))) +
                            list("Output", output + list("Levels", list("L", level)))));
  }
  /// What `toile check` says of the scene, which is good.
  std::string checked() {
    const Outcome outcome = toile("check scene.xml");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out.substr(0, outcome.out.find("fitted in"));
  }
  void expect_refused(const std::string& message) {
    const Outcome outcome = toile("check scene.xml");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr(message));
  }
  const std::string axis_ = array("axis bottom", "double", "100, -40, 0") + array("axis top", "double", "100, -40, 1");
};

// Landmarks stand for the numbers that `body landmarks` tells: heights of a wrap, points of its axis, a level.
TEST_F(LandmarkScene, StandForNumbers) {
  const Outcome marks = toile("body landmarks '" TOILE_SOURCE_DIR "/input/bodies/female_body.obj' --json marks.json");
  ASSERT_EQ(marks.status, 0) << marks.err;
  const auto json = nlohmann::json::parse(read("marks.json")).at("landmarks");
  const auto at = [&json](const std::string& name, int i) { return json.at(name).at("point").at(i).get<double>(); };
  const auto point = [&](const std::string& name, const std::string& landmark) {
    std::ostringstream text;
    text.precision(17);
    text << at(landmark, 0) << ", " << at(landmark, 1) << ", " << at(landmark, 2);
    return array(name, "double", text.str());
  };
  write_band(word("from", "left thigh - 90") + word("to", "left thigh - 30"), axis_, word("height", "left thigh - 60"));
  const std::string by_names = checked();
  const double thigh = at("left thigh", 2);
  write_band(number("from", thigh - 90.0) + number("to", thigh - 30.0), axis_, number("height", thigh - 60.0));
  EXPECT_EQ(by_names, checked());
  const std::string heights = number("from", 200.0) + number("to", 260.0), level = number("height", thigh - 60.0);
  write_band(heights, word("axis bottom", "left knee") + word("axis top", "left thigh"), level);
  const std::string along_leg = checked();
  write_band(heights, point("axis bottom", "left knee") + point("axis top", "left thigh"), level);
  EXPECT_EQ(along_leg, checked());
}

// Heights given by landmarks count along the axis that is given, and not from the floor.
TEST_F(LandmarkScene, AlongTheAxis) {
  const std::string from_600 =
      array("axis bottom", "double", "100, -40, 600") + array("axis top", "double", "100, -40, 601");
  write_band(word("from", "left thigh - 90") + word("to", "left thigh - 30"), axis_, word("height", "left thigh - 60"));
  const std::string from_floor = checked();
  write_band(word("from", "left thigh - 90") + word("to", "left thigh - 30"), from_600,
             word("height", "left thigh - 60"), array("axis point", "double", "0, 0, 600"));
  EXPECT_EQ(from_floor, checked());
}

// Lines on the body by landmarks: heights and points are those that the names tell.
TEST_F(LandmarkScene, Lines) {
  const std::string from = word("from", "left thigh - 90"), to = word("to", "left thigh - 30");
  const auto write_line = [&](const std::string& line) {
    write_band(from + to, axis_, word("height", "left thigh - 60"), list("Lines", list("line", line)));
  };
  write_line(word("type", "level") + word("height", "left thigh - 60") + word("from", "left thigh"));
  checked();
  write_line(word("type", "cut") + word("at", "left thigh") + array("normal", "double", "0, 0, 1"));
  expect_refused("Output > Lines > line: parameter \"at\"");
  expect_refused("(96.9978, -40.3787, 728.273) does not lie on the body's skin");
  write_line(word("type", "shortest way") + array("through", "string", "left thigh, left nee"));
  expect_refused("no landmark is named \"left nee\"; did you mean \"left knee\"?");
}

// A scene that names landmarks of a body whose trunk is round says that its front is taken for granted; one that names
// none does not.
TEST_F(LandmarkScene, OfARoundBody) {
  std::ifstream shipped(TOILE_SOURCE_DIR "/input/bodies/female_body.obj");
  std::ostringstream deeper;
  for (std::string line; std::getline(shipped, line);) {
    std::istringstream words(line);
    std::string kind;
    double x = 0.0, y = 0.0, z = 0.0;
    if (words >> kind && kind == "v" && words >> x >> y >> z)
      deeper << "v " << x << ' ' << 1.55 * y << ' ' << z << '\n';
    else
      deeper << line << '\n';
  }
  write("round.obj", deeper.str());
  const std::string body = word("type", "file") + word("file", "round.obj"), level = number("height", 668.0);
  const std::string at_thigh =
      array("axis bottom", "double", "100, -60, 0") + array("axis top", "double", "100, -60, 1");
  write_band(word("from", "left thigh - 90") + word("to", "left thigh - 30"), at_thigh, level, "", body);
  EXPECT_THAT(toile("check scene.xml").err, HasSubstr("which way it looks cannot be told from it"));
  write_band(number("from", 638.0) + number("to", 698.0), at_thigh, level, "", body);
  EXPECT_THAT(toile("check scene.xml").err, Not(HasSubstr("which way it looks")));
}

// A name that is none, a landmark without a body from a file, and a height along a bent axis are refused with the list,
// the parameter and the reason.
TEST_F(LandmarkScene, Refusals) {
  const std::string heights = number("from", 640.0) + number("to", 700.0);
  write_band(heights, axis_, word("height", "wiast"));
  expect_refused(
      "scene.xml: scene > Output > Levels > L: parameter \"height\" = \"wiast\": no landmark is named \"wiast\"; did "
      "you mean \"waist\"?");
  write_band(heights, axis_, word("height", "left thigh"), array("axis", "double", "100, -40, 0, 100, -40, 700"));
  expect_refused("parameter \"height\" = \"left thigh\": a landmark gives a height along a straight axis only");
  write_band(heights, axis_, word("height", "waist"), "", word("type", "cylinder") + number("radius", 60.0));
  expect_refused("scene > Body: parameter \"type\" = \"cylinder\": landmarks are found on bodies from files");
  write_band(heights, axis_, number("height", 650.0), list("Body points", list("p", word("at", "underbust"))));
  expect_refused("scene > Output > Body points > p: parameter \"at\"");
  write_band(word("from", "left thigh + x") + number("to", 700.0), axis_, number("height", 650.0));
  expect_refused("scene > Panels > band > Placement: parameter \"from\" = \"left thigh + x\"");
}

}  // namespace
}  // namespace toile::test
