#include "program.hpp"

namespace toile::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

using CommandLine = ProgramTest;

// Help names every subcommand and every exit status, and nothing of the libraries underneath.
TEST_F(CommandLine, HelpNamesSubcommandsAndExitStatus) {
  const Outcome help = toile("--help");
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("run "), HasSubstr("check "), HasSubstr("identify "), HasSubstr("describe "),
                              HasSubstr("0 success, 1 internal error, 2 bad input"), HasSubstr("3 a solve failed"),
                              HasSubstr("4 a check of the scene"), Not(HasSubstr("okkos"))));
  EXPECT_EQ(help.err, "");
}

// Help of a subcommand names its options.
TEST_F(CommandLine, HelpOfRunNamesItsOptions) {
  const Outcome help = toile("run --help");
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("--output DIR"), HasSubstr("--threads"), HasSubstr("--quiet")));
}

// The version is one line.
TEST_F(CommandLine, PrintsItsVersion) {
  const Outcome version = toile("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, ::testing::MatchesRegex("toile [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

// Without a subcommand the program says that it needs one.
TEST_F(CommandLine, AsksForASubcommand) {
  const Outcome outcome = toile("");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "toile: A subcommand is required. See toile --help\n");
  EXPECT_EQ(outcome.out, "");
}

// A misspelt subcommand is answered by the nearest one and the list of all.
TEST_F(CommandLine, SuggestsASubcommand) {
  const Outcome outcome = toile("chek scene.xml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err,
            "toile: unknown subcommand \"chek\"; did you mean \"check\"? Valid here: run report check dress material "
            "identify study compare body describe\n");
}

// A misspelt option is answered by the nearest one, whether its value is written with a blank or with "=".
TEST_F(CommandLine, SuggestsAnOption) {
  for (const char* arguments : {"run --threds 2 scene.xml", "run scene.xml --threds=2"}) {
    const Outcome outcome = toile(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(
        outcome.err,
        "toile: unknown option of \"toile run\" \"--threds\"; did you mean \"--threads\"? "
        "Valid here: --help --output --threads --heartbeat --report --quiet --no-pictures --restart --allow-plugins\n");
  }
}

// A missing scene, one argument too many and a bad number of threads are refused.
TEST_F(CommandLine, RefusesBadArguments) {
  const Outcome missing = toile("run");
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.err, HasSubstr("scene is required"));
  const Outcome many = toile("check one.xml two.xml");
  EXPECT_EQ(many.status, 2);
  EXPECT_THAT(many.err, HasSubstr("\"toile check\" does not take the argument \"two.xml\""));
  for (const char* threads : {"0", "many"}) {
    const Outcome bad = toile(std::string("run scene.xml --threads ") + threads);
    EXPECT_EQ(bad.status, 2);
    EXPECT_THAT(bad.err, HasSubstr("--threads"));
  }
}

// `describe` prints every list of a scene; with a list's name only that one.
TEST_F(CommandLine, DescribesLists) {
  const Outcome all = toile("describe");
  EXPECT_EQ(all.status, 0);
  for (const char* list :
       {"Body", "Materials", "Panels", "Seams", "Supports", "Loads", "Contact", "Stages", "Solver", "Output", "Checks"})
    EXPECT_THAT(all.out, HasSubstr(std::string("\nscene > ") + list + "\n"));
  const Outcome one = toile("describe Seams");
  EXPECT_EQ(one.status, 0);
  EXPECT_THAT(one.out, AllOf(HasSubstr("Seams > <seam>"), HasSubstr("ease  [double; allowed: 0 <= value <= 1; "),
                             Not(HasSubstr("Panels"))));
}

// What an error message says of a place, `describe` takes: the path, its end as a parameter, or the line as it is.
TEST_F(CommandLine, DescribesThePathsOfErrors) {
  const Outcome list = toile("describe 'scene > Panels > front > Placement'");
  EXPECT_EQ(list.status, 0);
  EXPECT_THAT(list.out, StartsWith("scene > Panels > <panel> > Placement\n"));
  const Outcome parameter = toile("describe 'Panels > front > elements across'");
  EXPECT_THAT(parameter.out, AllOf(StartsWith("Panels > <panel>, mesher = \"structured\"\n"),
                                   HasSubstr("  elements across  [int; "), Not(HasSubstr("elements along"))));
  const Outcome variants = toile("describe 'Body > radius'");
  EXPECT_THAT(variants.out, AllOf(HasSubstr("Body, type = \"cylinder\"\n"), HasSubstr("Body, type = \"sphere\"\n")));
  write_scene("strip", {{"value=\"rectangle\"", "value=\"rectangel\""}});
  const std::string message = toile("check scene.xml").err;
  const Outcome line = toile("describe '" + message + "'");
  EXPECT_THAT(line.out, AllOf(StartsWith("scene > Panels > <panel>\n"), HasSubstr("  shape  [string; allowed: ")))
      << message;
  EXPECT_THAT(toile("describe 'fit > Data > warp > noise'").out, HasSubstr("fit > Data > <curve>\n"));
  const Outcome misspelt = toile("describe 'scene > Panels > front > Placment'");
  EXPECT_EQ(misspelt.status, 2);
  EXPECT_THAT(misspelt.err, HasSubstr("there is no list or parameter \"Placment\"; did you mean \"Placement\"?"));
}

// Nothing in the reference reads like a number that is none.
TEST_F(CommandLine, DescribesWithoutNonNumbers) {
  const Outcome all = toile("describe");
  EXPECT_THAT(all.out, AllOf(Not(HasSubstr("default: nan")), Not(HasSubstr("default: inf")),
                             Not(HasSubstr("default: -inf")), Not(HasSubstr("e+30"))));
}

// A misspelt list is answered by the nearest one.
TEST_F(CommandLine, SuggestsAList) {
  const Outcome outcome = toile("describe Panel");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("there is no list or parameter \"Panel\"; did you mean \"Panels\"? Valid here: "));
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace toile::test
