// Inputs that could be read as something else, folders of results in odd states, and disks that fill up.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "app/exodus.hpp"
#include "app/program.hpp"
#include "toile/result/state_file.hpp"

namespace toile::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

class Hostile : public ProgramTest {
 protected:
  /// `toile check` and `toile run` refuse scene.xml with `message`.
  void expect_refused(const std::string& message) const {
    for (const std::string command : {"check", "run"}) {
      const Outcome outcome = toile(command + " scene.xml");
      EXPECT_EQ(outcome.status, 2) << outcome.err;
      EXPECT_THAT(outcome.err, HasSubstr(message)) << command;
    }
  }
  /// Every file of a folder with its content.
  std::map<std::string, std::string> contents(const std::string& folder) const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::directory_iterator(path(folder)))
      all[entry.path().filename().string()] =
          entry.is_regular_file() ? read(folder + "/" + entry.path().filename().string()) : "";
    return all;
  }
  /// `toile run scene.xml --output out` on a disk with so little space.
  Outcome run_with_space(int bytes) const {
    const std::string command = "cd '" + path("") +
                                "' && LD_PRELOAD='" TOILE_FULL_DISK "' TOILE_DISK_BYTES=" + std::to_string(bytes) +
                                " '" TOILE_PROGRAM "' run scene.xml --output out > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out.txt"), read("err.txt")};
  }
};

// A lost "<" drops no parameter, which would take its default (4.389 kPa in place of 2.182): it is refused with its
// line.
TEST_F(Hostile, TextBetweenElements) {
  write_scene("sleeve", {{"<Parameter name=\"offset\"", "Parameter name=\"offset\""}});
  expect_refused("scene.xml, line 29: scene > Panels > sleeve > Placement: the text Parameter name=\"offset\"");
}

// A number that is none in an array is refused with its place, not read as 0.
TEST_F(Hostile, NotANumberInAnArray) {
  write_scene("strip", {{"{0, 20, 0}", "{0, nan, 0}"}});
  expect_refused("scene > Supports > upper clamp: parameter \"move by\", value number 2, is nan, not a finite number");
}

// Two panels whose names end alike behind " > " are refused; they would be merged to one.
TEST_F(Hostile, NamesThatLookLikePaths) {
  write_scene("sleeve", {{"ParameterList name=\"sleeve\"", "ParameterList name=\"one > sleeve\""}});
  expect_refused("scene > Panels: the name \"one > sleeve\" holds \" > \"");
}

// A scene as a Windows editor saves it, with a byte order mark, gives what it gives without.
TEST_F(Hostile, ByteOrderMark) {
  write_scene("strip");
  const Outcome plain = toile("check scene.xml");
  write("scene.xml", "\xEF\xBB\xBF" + read("scene.xml"));
  const Outcome marked = toile("check scene.xml");
  EXPECT_EQ(marked.status, 0) << marked.err;
  EXPECT_EQ(marked.out, plain.out);
}

// Numbers that no machine can hold are refused by what they are before anything is made of them.
TEST_F(Hostile, LimitsOfSizes) {
  const auto integer = [](const std::string& name, const std::string& value) {
    return "<Parameter name=\"" + name + "\" type=\"int\" value=\"" + value + "\"/>";
  };
  write_scene("sleeve", {{integer("stations", "5"), integer("stations", "2147483647")}});
  expect_refused("parameter \"stations\" is out of range: 2147483647, allowed: 0 <= value <= 10000");
  write_scene("sleeve", {{integer("elements across", "20"), integer("elements across", "2147483647")}});
  expect_refused("parameter \"elements across\" is out of range");
  write_scene("sleeve", {{integer("elements across", "20"), integer("elements across", "10000")},
                         {integer("elements along", "9"), integer("elements along", "10000")}});
  expect_refused("with \"elements across\" = 10000 the panel has more than 1000000 elements");
  write_scene("sleeve", {{integer("stations", "5"), "<Parameter name=\"body size\" type=\"double\" value=\"0.02\"/>"}});
  expect_refused("parameter \"body size\" = 0.02: triangles of 0.02 mm would cut");
}

// A pipe or a device in the place of a scene or an included file is refused at once; reading it would never end.
TEST_F(Hostile, PipesAndDevices) {
  ASSERT_EQ(mkfifo(path("scene.xml").c_str(), 0600), 0);
  expect_refused("scene.xml: this is a pipe or a device, not a file");
  fs::remove(path("scene.xml"));
  write("scene.xml",
        "<ParameterList name=\"scene\"><Parameter name=\"include\" type=\"Array(string)\" value=\"{/dev/zero}\"/>"
        "</ParameterList>");
  expect_refused("but of the file /dev/zero: this is a pipe or a device, not a file");
}

// A run that is refused, whatever for, leaves the results of an earlier one as they are, to the last byte.
TEST_F(Hostile, RefusalsLeaveEarlierResults) {
  write_scene("sleeve");
  ASSERT_EQ(toile("run scene.xml --output out").status, 0);
  const auto before = contents("out");
  EXPECT_GT(before.size(), 6U);
  for (const std::string& name : {std::string("body"), std::string(100, 'n'), std::string(256, 'n')}) {
    write_scene("sleeve", {{"ParameterList name=\"sleeve\"", "ParameterList name=\"" + name + "\""},
                           {"sleeve.left", name + ".left"},
                           {"sleeve.right", name + ".right"},
                           {"{sleeve.bottom}", "{" + name + ".bottom}"},
                           {"{sleeve.top}", "{" + name + ".top}"}});
    const Outcome run = toile("run scene.xml --output out");
    EXPECT_EQ(run.status, 2) << name << run.err;
    EXPECT_EQ(contents("out"), before) << name;
  }
}

// A folder of results in which a file cannot be replaced is refused before anything is solved or removed.
TEST_F(Hostile, FilesThatCannotBeReplaced) {
  write_scene("strip");
  for (const std::string name : {"results.exo", "force-curves.csv"}) {
    write("out/" + name + "/inside", "something");
    write("out/history.h5", "older");
    const Outcome run = toile("run scene.xml --output out");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "toile: cannot write in the folder of the results \"out\": " + name + ": Is a directory\n");
    EXPECT_THAT(run.out, Not(HasSubstr("stage")));
    EXPECT_EQ(read("out/history.h5"), "older");
    fs::remove_all(path("out"));
  }
}

// Links that another user may have put into a shared folder of results are replaced, and what they lead to is
// untouched.
TEST_F(Hostile, LinksInTheFolderOfResults) {
  write_scene("strip");
  write("victim", "precious");
  fs::create_directory(path("out"));
  for (const char* name : {".writable", ".writable.new", "restart.h5.new", "restart.h5", "results.exo",
                           "history.h5.new", "force-curves.csv", "force-curves.svg", "force-curves.gp"})
    fs::create_symlink(path("victim"), path(std::string("out/") + name));
  EXPECT_EQ(toile("run scene.xml --output out").status, 0);
  EXPECT_EQ(read("victim"), "precious");
  EXPECT_FALSE(fs::is_symlink(path("out/results.exo")));
}

// A disk that fills up during a run is told with its reason and status 2, without a crash; what a reader then finds is
// whole: the earlier results if there was no step yet, else every step that was written.
TEST_F(Hostile, FullDisk) {
  write_scene("strip", {{"<Parameter name=\"first step\" type=\"double\" value=\"0.25\"/>",
                         "<Parameter name=\"first step\" type=\"double\" value=\"0.05\"/>"
                         "<Parameter name=\"largest step\" type=\"double\" value=\"0.05\"/>"}});
  write("out/results.exo", "older");
  const Outcome at_once = run_with_space(10000);
  EXPECT_EQ(at_once.status, 2);
  EXPECT_THAT(at_once.err, AllOf(HasSubstr("toile: cannot write "), HasSubstr("No space left on device")));
  EXPECT_EQ(read("out/results.exo"), "older");
  const Outcome later = run_with_space(700000);
  EXPECT_EQ(later.status, 2) << later.out;
  EXPECT_THAT(later.err, AllOf(HasSubstr("toile: cannot write "), HasSubstr("No space left on device")));
  const ExodusStep last(path("out/results.exo"));
  EXPECT_GT(last.steps, 1);
  EXPECT_LT(last.steps, 20);
  // The step that was interrupted may lack its state, which is then that of the step before.
  const result::StateData state = result::read_state(path("out/restart.h5"));
  EXPECT_THAT(state.integers.at("statistics: steps").front(), AnyOf(last.steps, last.steps - 1));
  EXPECT_EQ(state.reals.at("state: position").size(), 3u * 66u);
  EXPECT_THAT(last.position[2], Each(DoubleNear(0.0, 1e-9)));
  // With room again it goes on to its end, as it says.
  EXPECT_THAT(later.err, HasSubstr("toile run scene.xml --output out --restart"));
  EXPECT_EQ(toile("run scene.xml --output out --restart").status, 0);
  EXPECT_GT(ExodusStep(path("out/results.exo")).steps, 20);
}

// Who may not read a folder is told so with status 2. (The superuser may read all.)
TEST_F(Hostile, UnreadableFolders) {
  write("closed/scene.xml", "");
  fs::permissions(path("closed"), fs::perms::none);
  if (geteuid() != 0) {
    const Outcome run = toile("check closed/scene.xml");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err, "toile: closed/scene.xml: cannot open this file: Permission denied\n");
  }
  fs::permissions(path("closed"), fs::perms::owner_all);
  fs::create_symlink("scene.xml", path("scene.xml"));
  expect_refused("scene.xml: cannot open this file: Too many levels of symbolic links");
}

}  // namespace
}  // namespace toile::test
