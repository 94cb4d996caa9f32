// What holds for files of every format.
#include "toile/pattern/file.hpp"

#include <gmock/gmock.h>

#include <chrono>

#include "mutation.hpp"
#include "panels.hpp"
#include "scratch.hpp"

namespace toile::pattern::test {
namespace {

using testing::HasSubstr;

// An unknown ending is told with those that are known, also when writing.
TEST(File, UnknownEndings) {
  EXPECT_THAT(message([] { read_pattern("shirt.jsn"); }), HasSubstr("shirt.jsn: unknown ending \".jsn\""));
  EXPECT_THAT(message([] { read_pattern("shirt.jsn"); }), HasSubstr("\".json\""));
  EXPECT_THAT(message([] { write_pattern(everything(), "a.b/shirt"); }), HasSubstr("the name has no ending"));
  EXPECT_EQ(formats().size(), 3);
}

// Endings count in upper and lower case; a missing file and a folder are told.
TEST(File, MissingFiles) {
  EXPECT_THAT(message([] { read_pattern("missing.JSON"); }), HasSubstr("missing.JSON: cannot open this file"));
  EXPECT_THAT(message([] { write_pattern(everything(), "no/such/folder.svg"); }),
              HasSubstr("no/such/folder.svg: cannot write this file"));
  EXPECT_THAT(message([] { write_pattern(everything(), "no/such/folder.dxf"); }),
              HasSubstr("no/such/folder.dxf: cannot write this file"));
}

// A pattern that is not sound is not written.
TEST(File, UnsoundPatternIsNotWritten) {
  Pattern pattern = everything();
  pattern.panels[0].outline.pop_back();
  EXPECT_THAT(message([&] { write_pattern(pattern, "never.svg"); }), HasSubstr("the outline is open"));
}

class RealOutlines : public testing::TestWithParam<const char*> {};

// The outlines of real patterns, through every format, are the same within 0.002 mm.
TEST_P(RealOutlines, SurviveEveryFormat) {
  for (const char* name : {"gpg_tee.json", "gpg_tee_sleeveless.json", "garmentcode_shirt_mean_specification.json"}) {
    const Pattern pattern = read_pattern(std::string(TOILE_SOURCE_DIR "/test/data/patterns/") + name);
    const Scratch file(GetParam());
    write_pattern(pattern, file.path());
    const Pattern again = read_pattern(file.path());
    ASSERT_EQ(again.panels.size(), pattern.panels.size());
    for (std::size_t k = 0; k < again.panels.size(); ++k) expect_same(pattern.panels[k], again.panels[k], 0.002);
  }
}

INSTANTIATE_TEST_SUITE_P(File, RealOutlines, testing::Values(".json", ".svg", ".dxf"));

class Damaged : public testing::TestWithParam<const char*> {};

// Whatever is changed in a file, it is read or refused as the user's; nothing else is thrown, and nothing takes long.
TEST_P(Damaged, FilesAreReadOrRefused) {
  const Scratch source(GetParam()), damaged(GetParam());
  write_pattern(everything(), source.path());
  const std::string text = source.content();
  int read = 0, refused = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::ofstream(damaged.path()) << toile::test::Mutation(seed)(text);
    const auto begin = std::chrono::steady_clock::now();
    try {
      read_pattern(damaged.path());
      ++read;
    } catch (const base::InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(damaged.path()));
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5)) << "seed " << seed;
  }
  EXPECT_GT(read, 10);
  EXPECT_GT(refused, 25);
}

INSTANTIATE_TEST_SUITE_P(File, Damaged, testing::Values(".json", ".svg", ".dxf"));

}  // namespace
}  // namespace toile::pattern::test
