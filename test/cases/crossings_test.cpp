// Fabric that passes through fabric: told at the start and at the end of each stage, and shown in the results.
#include <numeric>
#include <sstream>

#include "app/exodus.hpp"
#include "app/program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string panels = R"(<ParameterList name="Panels">)", supports = R"(<ParameterList name="Supports">)",
                  output = R"(<ParameterList name="Output">)";

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

std::string flat_panel(const std::string& name, int width, int height, const std::string& origin, const std::string& x,
                       const std::string& y) {
  const std::string array = "Array(double)";
  return list(name, parameter("material", "string", "fabric") + parameter("shape", "string", "rectangle") +
                        parameter("width", "double", std::to_string(width)) +
                        parameter("height", "double", std::to_string(height)) +
                        parameter("elements across", "int", "4") + parameter("elements along", "int", "5") +
                        list("Placement", parameter("type", "string", "flat") + parameter("origin", array, origin) +
                                              parameter("x direction", array, x) + parameter("y direction", array, y)));
}

class CrossingScene : public ProgramTest {
 protected:
  /// A strip that is pulled, and a flag of 30 mm that is held where it stands in it.
  void write_flag(const std::string& options = "") const {
    const std::string held =
        list("flag", parameter("on", "Array(string)", "{flag}") + parameter("hold", "string", "xyz"));
    write_scene("strip", {{panels, panels + flat_panel("flag", 30, 40, "{10, 53, -21}", "{1, 0, 0}", "{0, 0, 1}")},
                          {supports, supports + held},
                          {output, output + options}});
  }
};

// A strip through which another one stands is warned of at the start and at the end of its stage, with the length on
// which they cross; table and field have the same length; the run is as good as any otherwise.
TEST_F(CrossingScene, IsToldOfAndShown) {
  write_flag();
  const Outcome outcome = toile("run scene.xml --output out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("the fabric starts passed through fabric: flag x strip ("));
  EXPECT_THAT(outcome.err, HasSubstr("at the end of stage \"pull\" fabric passes through fabric: flag x strip ("));
  EXPECT_THAT(outcome.err, HasSubstr(" pairs of elements, 30 mm long, "));
  const std::string table = read("out/crossings.csv");
  EXPECT_THAT(table, StartsWith("panel,pairs of elements,length [mm],depth [mm],x [mm],y [mm],z [mm],other panel\n"));
  std::istringstream row(table.substr(table.find('\n') + 1));
  std::string panel, pairs, length;
  std::getline(std::getline(std::getline(row, panel, ','), pairs, ','), length, ',');
  EXPECT_NEAR(std::stod(length), 30.0, 1e-6);
  const std::vector<double> field = ExodusStep(path("out/results.exo")).element("crossing");
  ASSERT_EQ(field.size(), 50U + 20U);
  EXPECT_NEAR(std::accumulate(field.begin(), field.end(), 0.0), 2.0 * 30.0, 1e-6);
}

// Two ranks tell the same as one.
TEST_F(CrossingScene, IsTheSameOnTwoRanks) {
  write_flag();
  const std::string one = toile("run scene.xml --quiet --output one").err;
  const std::string two = toile("run scene.xml --quiet --output two", 2).err;
  EXPECT_THAT(one, HasSubstr("passes through fabric"));
  EXPECT_EQ(one, two);
}

// Who does not want to know of it is not told, and pays for nothing: no field, no table.
TEST_F(CrossingScene, CanBeLeftOut) {
  write_flag(parameter("crossings", "bool", "false"));
  const Outcome outcome = toile("run scene.xml --output out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("through fabric")));
  EXPECT_FALSE(exists("out/crossings.csv"));
  EXPECT_TRUE(ExodusStep(path("out/results.exo")).element("crossing").empty());
}

// A wide tube that is draped through a label beside the body is told of before anything is solved; without the label
// there is nothing to tell.
TEST_F(CrossingScene, OfADrapedStartIsToldBeforeTheSettle) {
  const Edits wide = {
      {"value=\"145\"", "value=\"230\""},
      {"-72.5", "-115"},
      {"72.5, 80", "115, 80"},
      {"name=\"element size\" type=\"double\" value=\"7\"", "name=\"element size\" type=\"double\" value=\"10\""}};
  write_scene("draped", wide);
  EXPECT_THAT(toile("check scene.xml").err, Not(HasSubstr("through fabric")));
  Edits labelled = wide;
  labelled.push_back({panels, panels + flat_panel("label", 60, 40, "{70, -20, 52}", "{1, 0, 0}", "{0, 1, 0}")});
  write_scene("draped", labelled);
  EXPECT_THAT(toile("check scene.xml").err, AllOf(HasSubstr("the fabric starts passed through fabric: "),
                                                  HasSubstr("label x front ("), HasSubstr("label x back (")));
}

// Two sleeves of different meshes, sewn one upon the other on the same body, lie on each other and do not cross.
TEST_F(CrossingScene, LayeredSleevesDoNotCross) {
  write_scene("sleeve", {});
  std::string scene = read("scene.xml");
  const auto copy = [&](const std::string& begin, const std::string& end, const Edits& edits) {
    const size_t from = scene.find(begin), to = scene.find(end, from) + end.size();
    std::string text = scene.substr(from, to - from);
    for (const auto& [old, replacement] : edits)
      for (size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + replacement.size()))
        text.replace(at, old.size(), replacement);
    scene.insert(to, text);
  };
  copy(R"(<ParameterList name="sleeve">)", "</ParameterList>\n    </ParameterList>",
       {{"\"sleeve\"", "\"over\""}, {"\"20\"", "\"27\""}, {"\"9\"", "\"7\""}, {"\"200\"", "\"190\""}});
  copy(R"(<ParameterList name="side">)", "</ParameterList>", {{"side", "over side"}, {"sleeve", "over"}});
  for (const std::string end : {"bottom", "top"})
    copy("<ParameterList name=\"" + end + "\">", "</ParameterList>",
         {{"\"" + end + "\"", "\"over " + end + "\""}, {"sleeve", "over"}});
  write("scene.xml", scene);
  const Outcome outcome = toile("run scene.xml --output out");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("through fabric")));
  EXPECT_EQ(read("out/crossings.csv"),
            "panel,pairs of elements,length [mm],depth [mm],x [mm],y [mm],z [mm],other panel\n");
}

}  // namespace
}  // namespace toile::test
