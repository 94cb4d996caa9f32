// toile material check, as its user meets it: report, map, exit status, and what is said of bad input.
#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class MaterialCheck : public ProgramTest {
 protected:
  /// A file with the hosiery rebar law; `more`: further parameters of Material, `check`: those of Check.
  void write_fabric(const std::string& more, const std::string& check) const {
    write("hosiery.xml",
          "<ParameterList name=\"fabric\"><ParameterList name=\"Material\">"
          "<Parameter name=\"type\" type=\"string\" value=\"rebar\"/>"
          "<Parameter name=\"set\" type=\"string\" value=\"pantyhose\"/>" +
              more +
              "</ParameterList><ParameterList name=\"Check\">"
              "<Parameter name=\"points\" type=\"int\" value=\"12\"/>"
              "<Parameter name=\"shear points\" type=\"int\" value=\"3\"/>" +
              check + "</ParameterList></ParameterList>");
  }
  void expect_refused(const std::string& arguments, const std::string& message) const {
    const Outcome outcome = toile("material check " + arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
  }
};

std::string range(const std::string& name, const std::string& values) {
  return "<Parameter name=\"" + name + "\" type=\"Array(double)\" value=\"{" + values + "}\"/>";
}

const std::string literal = "<Parameter name=\"calibrated strain\" type=\"double\" value=\"10\"/>";

// The continued hosiery law passes: exit status 0, a table, the map as CSV and as pictures.
TEST_F(MaterialCheck, ContinuedHosieryPasses) {
  write_fabric("", "");
  const Outcome outcome = toile("material check hosiery.xml --output maps");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("hosiery (rebar): passed"), HasSubstr("ellipticity in tension  holds"),
                                 HasSubstr("path strip course"), HasSubstr("calibrated to 2.718")));
  EXPECT_THAT(read("maps/hosiery.csv"), HasSubstr("wale stretch,course stretch,shear,"));
  for (const char* name : {"stretches", "shear"})
    for (const char* end : {".dat", ".gp", ".svg", ".png"})
      EXPECT_TRUE(exists(std::string("maps/hosiery-") + name + end));
}

// The literal one fails: exit status 4, and the message names the criteria; the table tells at which stretch.
TEST_F(MaterialCheck, LiteralHosieryFails) {
  write_fabric(literal, "");
  const Outcome outcome = toile("material check hosiery.xml");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.err, HasSubstr("hosiery: ellipticity in tension; hosiery: convexity in tension"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("hosiery (rebar): FAILED"), HasSubstr("ellipticity in tension  FAILS"),
                                 HasSubstr("ellipticity lost at 3.4")));
  EXPECT_TRUE(exists("results/hosiery-check/hosiery.csv"));
}

// Only the criteria that are asked for count.
TEST_F(MaterialCheck, OnlyRequiredCriteriaCount) {
  write_fabric(literal, "<Parameter name=\"criteria\" type=\"Array(string)\" value=\"{natural state, derivatives}\"/>");
  const Outcome outcome = toile("material check hosiery.xml");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("ellipticity in tension  lost"));
}

// A material of a scene is checked by its name.
TEST_F(MaterialCheck, MaterialOfAScene) {
  write_scene("strip");
  const Outcome outcome = toile("material check scene.xml fabric");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("fabric (itskov): passed"));
}

// The shipped examples do what their comments say.
TEST_F(MaterialCheck, ShippedFabrics) {
  const std::string folder = "material check " TOILE_SOURCE_DIR "/input/fabrics/";
  EXPECT_EQ(toile(folder + "hosiery-rebar.xml").status, 0);
  EXPECT_EQ(toile(folder + "hosiery-rebar-literal.xml").status, 4);
}

// Every published set, and the literal forms for comparison.
TEST_F(MaterialCheck, AllPublishedSets) {
  const Outcome outcome = toile("material check --all --output maps");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("itskov, pantyhose (itskov): passed"), HasSubstr("itskov, t-shirt (itskov): passed"),
                    HasSubstr("rebar, pantyhose (rebar): passed"),
                    HasSubstr("rebar, pantyhose, literal (not continued) (rebar): FAILED")));
  EXPECT_TRUE(exists("maps/itskov-t-shirt-shear.svg"));
}

// Bad boxes and names.
TEST_F(MaterialCheck, BadInput) {
  write_fabric("", range("wale stretch", "3, 1"));
  expect_refused("hosiery.xml",
                 "hosiery.xml: fabric > Check: parameter \"wale stretch\" = {3, 1}: the range is reversed");
  write_fabric("", range("course stretch", "2, 2"));
  expect_refused("hosiery.xml", "the box is empty");
  write_fabric("", range("course stretch", "0, 2"));
  expect_refused("hosiery.xml", "allowed: > 0");
  write_fabric("", "<Parameter name=\"criteria\" type=\"Array(string)\" value=\"{elipticity}\"/>");
  expect_refused("hosiery.xml", "unknown criterion \"elipticity\"; did you mean \"ellipticity\"?");
  write_fabric("<Parameter name=\"c9\" type=\"double\" value=\"1\"/>", "");
  expect_refused("hosiery.xml", "fabric > Material: unknown parameter \"c9\"");
}

// An unknown material of a scene, a scene without the name of one, no file at all, a file beside --all.
TEST_F(MaterialCheck, BadCommandLine) {
  write_scene("strip");
  expect_refused("scene.xml fabrik",
                 "scene.xml: scene > Materials: unknown material \"fabrik\"; did you mean \"fabric\"?");
  expect_refused("scene.xml", "name one of its materials too: toile material check scene.xml MATERIAL");
  expect_refused("", "material check: name a fabric's XML file");
  expect_refused("scene.xml --all", "material check: --all takes no file");
  expect_refused("missing.xml", "missing.xml");
  expect_refused("--al", "unknown option of \"toile material check\" \"--al\"; did you mean \"--all\"?");
}

// One rank is enough, and several would write the same files.
TEST_F(MaterialCheck, RunsOnOneRank) {
  const Outcome outcome = toile("material check --all", 2);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("material check runs on one rank"));
}

// The list is described like those of a scene.
TEST_F(MaterialCheck, IsDescribed) {
  const Outcome outcome = toile("describe Check");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("wale stretch"), HasSubstr("ellipticity in tension"), Not(HasSubstr("Panels"))));
}

}  // namespace
}  // namespace toile::test
