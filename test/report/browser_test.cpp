// The page in a browser without a screen.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "example.hpp"

namespace toile::report::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class ReportInBrowser : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium > /dev/null") != 0) GTEST_SKIP() << "there is no chromium";
  }
};

/// The document of a page after its scripts have run.
std::string document(const Example& example) {
  example.report();
  const std::string dom = example.folder.file("dom.html");
  const std::string command =
      "timeout 240 chromium --headless --no-sandbox --enable-unsafe-swiftshader --user-data-dir=" +
      example.folder.file("browser") + " --virtual-time-budget=5000 --dump-dom file://" + example.page() + " > " + dom +
      " 2> " + dom + ".err";
  EXPECT_EQ(std::system(command.c_str()), 0) << result::test::read_text(dom + ".err");
  return result::test::read_text(dom);
}

/// The start tag of the document, with what the scripts mark there.
std::string marks(const std::string& document) {
  const std::size_t begin = document.find("<html");
  return begin == std::string::npos ? "no document" : document.substr(begin, document.find('>', begin) - begin);
}

// The scripts reach their end without an error, with every node, and draw. A reader finds the warning, the pressures
// with their errors and the scene's parameter as text, and markup as what it is. The legend tells the largest pressure,
// 0.02 kPa/mm times 80 mm in the second step, in kPa and mmHg.
TEST_F(ReportInBrowser, ShowsTheRun) {
  const Example example;
  const std::string page = document(example), found = marks(page);
  EXPECT_THAT(found, HasSubstr("data-ready=\"yes\""));
  EXPECT_THAT(found, HasSubstr("data-view=\"drawn\""));
  EXPECT_THAT(found, HasSubstr("data-garment-nodes=\"" + std::to_string(example.garment_nodes) + "\""));
  EXPECT_THAT(found, HasSubstr("data-body-nodes=\"" + std::to_string(example.body_nodes) + "\""));
  EXPECT_THAT(found, Not(HasSubstr("data-error")));
  EXPECT_THAT(page, HasSubstr(" data-drawn=\""));  // frames of the view
  EXPECT_THAT(page, HasSubstr("<li class=\"alert\">fabric &lt;/script&gt; is slack</li>"));
  EXPECT_THAT(page, HasSubstr("A sleeve &lt;b&gt;</h1>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">B, ankle</th><td>1.36</td><td>0.042</td><td>0.031</td>"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">heel</th><td>2.47</td>"));
  EXPECT_THAT(page, HasSubstr("0.0617</td>"));
  EXPECT_THAT(page, HasSubstr("<span id=\"legend-high\">3.2 kPa (24 mmHg)</span>"));
}

// Lines on the body are drawn each with its name, measured points over the line that they lie on, and beside computed
// values in a table of their own.
TEST_F(ReportInBrowser, ShowsLinesAndMeasuredPoints) {
  const Example example;
  example.write("pressure-lines.csv",
                "line,arc length [mm],x [mm],y [mm],z [mm],pressure [kPa],pressure [mmHg],its error [kPa],its error "
                "[mmHg],gap [mm]\nshin,0,60,0,0,1.5,11.25,0.1,0.75,0\nshin,37.5,60,0,37.5,1.25,9.375,0.1,0.75,0\n"
                "calf,0,-60,0,0,1.75,13.125,0.1,0.75,0\ncalf,37.5,-60,0,37.5,1.125,8.4375,0.1,0.75,0\n");
  example.write("pressure-compared.csv",
                "name,x [mm],y [mm],z [mm],measured [kPa],its scatter [kPa],computed [kPa],its error "
                "[kPa],deviation [kPa],within both\nsensor 1,62,0,36,1.3125,0.0625,1.26,0.1,-0.0525,yes\n"
                "sensor 2,0,90,0,2.5,0.125,1.5,0.1,-1,no\n");
  const std::string page = document(example);
  EXPECT_THAT(marks(page), HasSubstr("data-ready=\"yes\""));
  EXPECT_THAT(marks(page), Not(HasSubstr("data-error")));
  EXPECT_THAT(page, HasSubstr("<figcaption>Pressure along lines on the body</figcaption>"));
  EXPECT_THAT(page, HasSubstr("diamonds: measured within 10 mm of the line, with their scatter"));
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">calf</th><td>37.5</td><td>1.125</td><td>0.1</td>"));
  EXPECT_THAT(page,
              HasSubstr("<th scope=\"row\">sensor 2</th><td>2.5 ± 0.13</td><td>1.5 ± 0.1</td><td>-1</td><td>no</td>"));
}

// A table without a line, and results with neither record nor error of the pressure, are no fault.
TEST_F(ReportInBrowser, DoesWithLess) {
  const Example example({"pressure"});
  example.write("pressure-levels.csv", "");
  std::filesystem::remove(example.folder.file("run.json"));
  const std::string found = marks(document(example));
  EXPECT_THAT(found, HasSubstr("data-ready=\"yes\""));
  EXPECT_THAT(found, Not(HasSubstr("data-error")));
}

}  // namespace
}  // namespace toile::report::test
