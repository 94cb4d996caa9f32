#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "toile/base/error.hpp"
#include "toile/study/study.hpp"

namespace toile::study {
namespace {

using testing::HasSubstr;

const std::string tube = TOILE_SOURCE_DIR "/examples/tube.xml";

/// A file of a study of the tube, with what is varied.
class ReadStudy : public testing::Test {
 protected:
  ReadStudy() : folder_(testing::TempDir() + "toile-study-read") { std::filesystem::create_directories(folder_); }
  ~ReadStudy() override { std::filesystem::remove_all(folder_); }

  Study read(const std::string& vary, const std::string& more = "") const {
    const std::string file = folder_ + "/study.xml";
    std::ofstream(file) << "<ParameterList name=\"study\">\n<Parameter name=\"scene\" type=\"string\" value=\"" << tube
                        << "\"/>\n"
                        << more << "<ParameterList name=\"Vary\">" << vary
                        << "</ParameterList>\n<ParameterList name=\"Quantities\"><ParameterList name=\"p\">"
                           "<Parameter name=\"type\" type=\"string\" value=\"level\"/>"
                           "<Parameter name=\"of\" type=\"string\" value=\"middle\"/></ParameterList></ParameterList>\n"
                           "</ParameterList>\n";
    return read_study(file, false);
  }
  std::string error(const std::string& vary, const std::string& more = "") const {
    try {
      read(vary, more);
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "no error";
  }
  static std::string change(const std::string& name, const std::string& path, const std::string& values,
                            const std::string& more = "") {
    return "<ParameterList name=\"" + name + "\"><Parameter name=\"paths\" type=\"Array(string)\" value=\"{" + path +
           "}\"/><Parameter name=\"values\" type=\"Array(string)\" value=\"{" + values + "}\"/>" + more +
           "</ParameterList>";
  }

 private:
  std::string folder_;
};

const std::string across = "Panels/tube/elements across", along = "Panels/tube/elements along";

// Changes that are combined make a grid, the last one changing fastest; those that go together make one row of it. Each
// case has a folder of its own, and says what differs from the scene and nothing else.
TEST_F(ReadStudy, MakesAGridOfCases) {
  const std::string with = "<Parameter name=\"with\" type=\"string\" value=\"mesh\"/>";
  const Study study = read(change("mesh", across, "12, 24, 48") + change("rows", along, "2, 4, 8", with) +
                           change("origin", "Panels > tube > Placement > axis bottom", "0 0 0, 0 0 -1"));
  ASSERT_EQ(study.axes.size(), 2U);
  ASSERT_EQ(study.cases.size(), 6U);
  std::set<std::string> names;
  for (const Case& one : study.cases) names.insert(one.name);
  EXPECT_EQ(names.size(), 6U);
  const Teuchos::ParameterList content = study.cases[3].scene.content();
  const Teuchos::ParameterList& panel = content.sublist("Panels").sublist("tube");
  EXPECT_EQ(panel.get<int>("elements across"), 24);
  EXPECT_EQ(panel.get<int>("elements along"), 4);
  EXPECT_EQ(panel.sublist("Placement").get<Teuchos::Array<double>>("axis bottom"),
            Teuchos::Array<double>(Teuchos::tuple(0.0, 0.0, -1.0)));
  EXPECT_EQ(content.numParams(), 2) << "what is included, and the panels";
}

// A path that does not exist is refused before anything runs, with the nearest name that is valid there.
TEST_F(ReadStudy, RefusesAPathThatDoesNotExist) {
  EXPECT_THAT(error(change("a", "Panels/tub/height", "40")),
              HasSubstr("path \"Panels/tub/height\": there is no list \"tub\"; did you mean \"tube\"?"));
  EXPECT_THAT(error(change("a", "Panels/tube/heigth", "40")),
              HasSubstr("there is no parameter \"heigth\"; did you mean \"height\"?"));
  EXPECT_THAT(error(change("a", "Panel/tube/height", "40")),
              HasSubstr("there is no list \"Panel\"; did you mean \"Panels\"?"));
  EXPECT_THAT(error(change("a", across, "12, many")),
              HasSubstr("the value is \"many\", expected a whole number (int)"));
  EXPECT_THAT(error(change("a", "run/threads", "0")), HasSubstr("expected a whole number, 1 to 1024"));
}

// What does not fit together in the file is refused with the parameter at fault.
TEST_F(ReadStudy, RefusesWhatDoesNotFit) {
  const std::string with = "<Parameter name=\"with\" type=\"string\" value=\"msh\"/>";
  EXPECT_THAT(error(change("mesh", across, "12, 24") + change("rows", along, "2, 4", with)),
              HasSubstr("parameter \"with\" = \"msh\": names no change that is combined with all others; did you "
                        "mean \"mesh\"?"));
  EXPECT_THAT(error(change("mesh", across, "12, 24"), "<Parameter name=\"refine\" type=\"string\" value=\"meshes\"/>"),
              HasSubstr("did you mean \"mesh\"?"));
  EXPECT_THAT(error(change("mesh", across, "12, 12")), HasSubstr("holds an entry twice"));
}

// A case is another one when its scene, or a file of it, is.
TEST_F(ReadStudy, IdentityIsThatOfTheInput) {
  const Study one = read(change("mesh", across, "12, 24")), again = read(change("mesh", across, "24, 48"));
  EXPECT_NE(one.cases[0].identity, one.cases[1].identity);
  EXPECT_EQ(one.cases[1].identity, again.cases[0].identity);
}

}  // namespace
}  // namespace toile::study
