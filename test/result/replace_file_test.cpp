#include "toile/result/replace_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "support.hpp"
#include "toile/base/error.hpp"

namespace toile::result::test {
namespace {

// A file takes the place of an older one when it is complete, and not before; nothing is left of one that never is.
TEST(ReplaceFile, TakesThePlaceAsAWhole) {
  const TemporaryFolder folder;
  const std::string path = folder.file("table.csv");
  replace_file(path, "older", "");
  EXPECT_EQ(read_text(path), "older");
  {
    Replacement newer(path, "");
    newer.write("newer");
    EXPECT_EQ(read_text(path), "older");
  }
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
  Replacement newer(path, "");
  newer.write("new");
  newer.write("er");
  newer.take_place();
  EXPECT_EQ(read_text(path), "newer");
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

// What cannot be replaced is refused with the reason before anything is written.
TEST(ReplaceFile, NamesTheReason) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("table.csv"));
  EXPECT_EQ(input_error([&] { replace_file(folder.file("table.csv"), "", "cannot write: "); }),
            "cannot write: Is a directory");
  EXPECT_EQ(input_error([&] { replace_file(folder.file("no/table.csv"), "", "cannot write: "); }),
            "cannot write: No such file or directory");
  remove_file(folder.file("no/table.csv"), "");
  EXPECT_EQ(input_error([&] { remove_file(folder.file("table.csv"), "cannot remove: "); }),
            "cannot remove: Is a directory");
}

// Another user's file in a folder where each may remove his own only is refused beforehand. (The superuser can play
// both.)
TEST(ReplaceFile, FilesOfOthersInASharedFolder) {
  if (geteuid() != 0) GTEST_SKIP() << "needs the superuser";
  const TemporaryFolder folder;
  std::ofstream(folder.file("table.csv")) << "theirs";
  ASSERT_EQ(chmod(folder.path().c_str(), 01777), 0);
  const pid_t child = fork();
  if (child == 0) {
    const bool other = seteuid(65534) == 0;
    try {
      check_replaceable(folder.file("table.csv"), "cannot write: ");
    } catch (const base::InputError& error) {
      const std::string expected =
          "cannot write: it belongs to another user, and in this folder each may replace his own files only";
      _exit(other && error.what() == expected ? 0 : 1);
    }
    _exit(2);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(read_text(folder.file("table.csv")), "theirs");
}

}  // namespace
}  // namespace toile::result::test
