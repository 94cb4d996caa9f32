// What the file of a report holds, and what is refused.
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>

#include "example.hpp"
#include "toile/report/report.hpp"
#include "toile/result/exodus_writer.hpp"

namespace toile::report::test {
namespace {

using result::test::input_error;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string refusal(const std::string& results) {
  return input_error([&] { write_report(results, results + ".html"); });
}

// The page holds pressures of levels and points, warnings and the scene, with nothing that ends its data early.
TEST(ReportPage, HoldsTablesWarningsAndScene) {
  const std::string page = Example().report();
  for (const char* value : {"1.357", "0.0421", "2.468", "0.135", "0.0617", "scene > Materials > jersey > mu"})
    EXPECT_THAT(page, HasSubstr(value));
  EXPECT_THAT(page, HasSubstr("fabric \\u003c/script> is slack"));
}

// Nothing of the page comes from elsewhere.
TEST(ReportPage, HasNoExternalReferences) {
  const std::string page = Example().report();
  EXPECT_FALSE(std::regex_search(page, std::regex("<(link|img|iframe|script +src)\\b")));
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href) *= *[\"']?(https?:)?//")));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

// Most of a small report are the libraries, with their licences: 0.87 MB of 0.95.
TEST(ReportPage, BringsItsLibraries) {
  const Example example;
  const Written written = write_report(example.results(), example.page());
  EXPECT_EQ(written.bytes, std::filesystem::file_size(example.page()));
  EXPECT_GT(written.bytes, 500'000U);
  EXPECT_LT(written.bytes, 2'000'000U);
  EXPECT_THAT(written.left_out, ElementsAre());
  EXPECT_THAT(result::test::read_text(example.page()), HasSubstr("The MIT License"));
}

// A page that would be too large leaves out the fields that are wanted least, and says so.
TEST(ReportPage, LeavesOutFieldsForItsSize) {
  const Example example({"cauchy_major", "pressure"});
  const Written written = write_report(example.results(), example.page(), {1000});
  EXPECT_THAT(written.left_out, ElementsAre("stretch_wale", "cauchy_major"));
  EXPECT_THAT(result::test::read_text(example.page()), HasSubstr(R"("leftOut":["stretch_wale","cauchy_major"])"));
}

// Results of an older program, without a field, give a page without it.
TEST(ReportPage, DoesWithoutAField) {
  EXPECT_THAT(Example().report(), HasSubstr(R"("name":"pressure_error")"));
  EXPECT_THAT(Example({"pressure"}).report(), Not(HasSubstr(R"("name":"pressure_error")")));
}

// Results without the record of the run give a page that says what is not known.
TEST(ReportPage, SaysThatTheRecordIsMissing) {
  const Example example;
  std::filesystem::remove(example.folder.file("run.json"));
  EXPECT_THAT(example.report(), HasSubstr("There is no run.json beside the results"));
}

// A record of another number of steps is told of: its warnings may be of another state.
TEST(ReportPage, SaysThatTheRecordIsOfAnotherState) {
  const Example example;
  example.write("run.json", R"({"format": "toile run 1", "end": "reached", "steps": 7})");
  EXPECT_THAT(example.report(), HasSubstr("The results hold 2 steps and run.json tells of 7"));
}

// A missing file, one that is no Exodus file, and a folder are refused with the reason; no page is made.
TEST(ReportPage, RefusesWhatIsNoResult) {
  const Example example;
  EXPECT_THAT(refusal(example.folder.file("other.exo")), HasSubstr("other.exo"));
  example.write("text.exo", "not a result");
  EXPECT_THAT(refusal(example.folder.file("text.exo")), HasSubstr("text.exo: it is not an Exodus file"));
  EXPECT_FALSE(std::filesystem::exists(example.folder.file("text.exo.html")));
}

// A file that was cut off anywhere is refused; the library that reads it would take zeros for what is not there.
TEST(ReportPage, RefusesWhatWasCutOff) {
  const Example example;
  const std::string whole = result::test::read_text(example.results());
  for (const std::size_t size : {whole.size() - 1, whole.size() / 2, std::size_t{100}, std::size_t{6}}) {
    example.write("cut.exo", whole.substr(0, size));
    EXPECT_THAT(refusal(example.folder.file("cut.exo")), HasSubstr("cut.exo: it was cut off")) << size;
  }
}

// A record that is not one is refused, by name.
TEST(ReportPage, RefusesAnotherRecord) {
  const Example example;
  example.write("run.json", "{\"format\": 3");
  EXPECT_THAT(input_error([&] { example.report(); }), HasSubstr("run.json: it is not the record of a run"));
}

}  // namespace
}  // namespace toile::report::test
