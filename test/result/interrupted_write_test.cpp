// Files of a run that is killed, or whose disk fills up, at any moment of its writing.
#include <exodusII.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include "support.hpp"
#include "toile/base/error.hpp"
#include "toile/result/exodus_writer.hpp"
#include "toile/result/history.hpp"
#include "toile/result/state_file.hpp"

/// The C library's writes, of this program and its libraries.
namespace interposed {

/// What the writes of a child do; -1: as always.
struct Writes {
  long done = 0;
  long kill_at = -1;
  long full_from = -1;
};
inline Writes writes;

/// Whether this write fails for want of space.
inline bool next_write_fails() {
  ++writes.done;
  if (writes.done == writes.kill_at) kill(getpid(), SIGKILL);
  return writes.full_from >= 0 && writes.done >= writes.full_from;
}

}  // namespace interposed

// These take the place of the C library's, in the libraries too.
extern "C" ssize_t write(int file, const void* data, size_t size) {
  if (file > 2 && interposed::next_write_fails()) {
    errno = ENOSPC;
    return -1;
  }
  return syscall(SYS_write, file, data, size);
}
extern "C" ssize_t pwrite(int file, const void* data, size_t size, off_t at) {
  return syscall(SYS_pwrite64, file, data, size, at);  // of what undoes a step, which needs no space
}

namespace toile::result::test {
namespace {

using interposed::writes;

constexpr int nodes = 707;  ///< of the tube; a field is longer than what netCDF writes at a time
constexpr int steps = 3;

double radius(double /*z*/) {
  return 30.0;
}

mesh::Mesh garment() {
  return tube(radius, 0.0, 60.0, 100, 6);
}

double value(int step, int node) {
  return 1000.0 * step + node;
}

/// Writes the steps as a run does.
void write_all(const TemporaryFolder& folder) {
  const mesh::Mesh mesh = garment();
  FieldNames fields;
  fields.nodal = {{"pressure", "kPa"}};
  fields.element = {{"thickness", "mm"}};
  fields.global = {{"load", ""}};
  ExodusWriter writer(folder.file("results.exo"), mesh, nullptr, fields);
  History history(folder.file("history.h5"), {{"load", ""}, {"energy", "N mm"}});
  for (int step = 1; step <= steps; ++step) {
    StepData data;
    data.displacement.assign(static_cast<std::size_t>(mesh.nodes()), mesh::Vec3(step, 0, 0));
    for (int n = 0; n < mesh.nodes(); ++n) data.nodal["pressure"].push_back(value(step, n));
    data.element["thickness"].assign(static_cast<std::size_t>(mesh.elements()), step);
    data.global["load"] = step;
    writer.write_step(step, data);
    history.append({1.0 * step, 2.0 * step});
    StateData state;
    state.reals["position"] = data.nodal["pressure"];
    write_state(folder.file("restart.h5"), state);
  }
}

/// Number of steps of the Exodus file, every one of which must hold its values; -1: there is no file.
int complete_steps(const std::string& path) {
  if (!std::filesystem::exists(path)) return -1;
  int memory_word = sizeof(double);
  int file_word = 0;
  float version = 0.0F;
  const int id = ex_open(path.c_str(), EX_READ, &memory_word, &file_word, &version);
  EXPECT_GE(id, 0);
  const int found = static_cast<int>(ex_inquire_int(id, EX_INQ_TIME));
  for (int step = 1; step <= found; ++step) {
    double time = 0.0;
    EXPECT_EQ(ex_get_time(id, step, &time), 0);
    EXPECT_EQ(time, step);
    std::vector<double> values(nodes);
    EXPECT_EQ(ex_get_var(id, step, EX_NODAL, 6, 1, nodes, values.data()), 0);
    for (int n = 0; n < nodes; ++n) EXPECT_EQ(values[static_cast<std::size_t>(n)], value(step, n)) << step;
    std::vector<double> thickness(600);
    EXPECT_EQ(ex_get_var(id, step, EX_ELEM_BLOCK, 1, 1, 600, thickness.data()), 0);
    EXPECT_EQ(thickness, std::vector<double>(600, step));
  }
  ex_close(id);
  return found;
}

/// Runs `write_all` in a child; its exit status, or the negative of the signal that ended it.
template <class Action>
int in_a_child(Action action) {
  const pid_t child = fork();
  if (child == 0) {
    writes.done = 0;
    action();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

/// The state is whole, and of the last step of the Exodus file or the one before.
void check_state(const std::string& path, int last) {
  if (!std::filesystem::exists(path)) {
    EXPECT_LE(last, 1);
    return;
  }
  const std::vector<double> position = read_state(path).reals.at("position");
  ASSERT_EQ(position.size(), static_cast<std::size_t>(nodes));
  EXPECT_TRUE(position[0] == value(last, 0) || position[0] == value(last - 1, 0)) << position[0];
  EXPECT_EQ(position.back() - position.front(), nodes - 1.0);
}

class InterruptedWrite : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { ex_opts(EX_DEFAULT); }
};

// A run that is killed at any of its writes leaves files in which every step that a reader sees is whole.
TEST_F(InterruptedWrite, AKillLeavesWholeSteps) {
  int largest = -1;
  for (long at = 1;; ++at) {
    SCOPED_TRACE("write " + std::to_string(at));
    const TemporaryFolder folder;
    const int status = in_a_child([&] {
      writes.kill_at = at;
      write_all(folder);
    });
    const int last = complete_steps(folder.file("results.exo"));
    largest = std::max(largest, last);
    check_state(folder.file("restart.h5"), last);
    if (status == 0) break;
    ASSERT_EQ(status, -SIGKILL);
    ASSERT_LT(at, 2000);
  }
  EXPECT_EQ(largest, steps);
}

// A disk that fills up at any write is told with its reason, and the steps before stay as they were.
TEST_F(InterruptedWrite, AFullDiskIsToldAndLeavesWholeSteps) {
  for (long from = 1;; ++from) {
    SCOPED_TRACE("write " + std::to_string(from));
    const TemporaryFolder folder;
    std::ofstream(folder.file("message")) << "";
    const int status = in_a_child([&] {
      writes.full_from = from;
      try {
        write_all(folder);
      } catch (const base::InputError& error) {
        writes.full_from = -1;
        std::ofstream(folder.file("message")) << error.what();
        std::exit(static_cast<int>(error.code()));  // with what the libraries do at the end
      }
    });
    const int last = complete_steps(folder.file("results.exo"));
    check_state(folder.file("restart.h5"), last);
    if (status == 0) break;
    ASSERT_EQ(status, 2);
    EXPECT_NE(read_text(folder.file("message")).find("No space left on device"), std::string::npos)
        << read_text(folder.file("message"));
    for (const char* name : {"results.exo.new", "history.h5.new", "restart.h5.new"})
      EXPECT_FALSE(std::filesystem::exists(folder.file(name))) << name;
    ASSERT_LT(from, 2000);
  }
}

// An older file stays as it is until the first step of the new one is whole.
TEST_F(InterruptedWrite, TheOlderFileStaysUntilTheFirstStep) {
  const TemporaryFolder folder;
  for (const char* name : {"results.exo", "history.h5", "restart.h5"}) std::ofstream(folder.file(name)) << "older";
  long at = 1;
  for (; read_text(folder.file("results.exo")) == "older"; ++at) {
    const int status = in_a_child([&] {
      writes.kill_at = at;
      write_all(folder);
    });
    ASSERT_EQ(status, -SIGKILL);
    EXPECT_EQ(read_text(folder.file("restart.h5")), "older");
  }
  EXPECT_GT(at, 10);
  EXPECT_EQ(complete_steps(folder.file("results.exo")), 1);
}

// What lies where a file is written is replaced, and a link there is not followed.
TEST_F(InterruptedWrite, FollowsNoLinks) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("victim")) << "precious";
  for (const char* name : {"results.exo", "history.h5", "restart.h5"})
    for (const char* ending : {"", ".new"})
      std::filesystem::create_symlink(folder.file("victim"), folder.file(std::string(name) + ending));
  write_all(folder);
  EXPECT_EQ(read_text(folder.file("victim")), "precious");
  EXPECT_EQ(complete_steps(folder.file("results.exo")), steps);
  EXPECT_FALSE(std::filesystem::is_symlink(folder.file("restart.h5")));
}

}  // namespace
}  // namespace toile::result::test
