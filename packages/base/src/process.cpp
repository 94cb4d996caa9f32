#include "toile/base/process.hpp"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "toile/base/error.hpp"

namespace toile::base {
namespace {

/// A file without a name, so that neither side waits for the other to read.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& content = "") : file_(memfd_create("toile", MFD_CLOEXEC)) {
    for (std::size_t done = 0; file_ >= 0 && done < content.size();) {
      const ssize_t n = write(file_, content.data() + done, content.size() - done);
      if (n <= 0) break;
      done += static_cast<std::size_t>(n);
    }
    if (file_ < 0 || lseek(file_, 0, SEEK_CUR) != static_cast<off_t>(content.size()))
      throw Error(ExitCode::internal_error, "no memory for what another program is to read or write");
    lseek(file_, 0, SEEK_SET);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(file_); }

  int number() const { return file_; }
  std::string content() const {
    std::string all;
    std::array<char, 1 << 16> buffer{};
    lseek(file_, 0, SEEK_SET);
    for (ssize_t n = 0; (n = read(file_, buffer.data(), buffer.size())) > 0;) all.append(buffer.data(), n);
    return all;
  }

 private:
  int file_;
};

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Waits for the end of a process, and ends its group after its time or if that is wanted.
void wait_for(pid_t process, const ProcessOptions& options, ProcessEnd& end) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  int status = 0;
  rusage usage{};
  while (wait4(process, &status, WNOHANG, &usage) == 0) {
    end.out_of_time = end.out_of_time || (!end.stopped && seconds() > options.most_seconds);
    end.stopped = end.stopped || (!end.out_of_time && options.stop && options.stop());
    if (end.out_of_time || end.stopped) kill(-process, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  end.seconds = seconds();
  end.processor_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
  end.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

namespace {

/// The environment that this program was started with.
std::vector<std::string> first_environment() {
  std::vector<std::string> variables;
  std::ifstream file("/proc/self/environ", std::ios::binary);
  for (std::string variable; std::getline(file, variable, '\0');) variables.push_back(variable);
  return variables;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

}  // namespace

ProcessEnd run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  const MemoryFile input(options.input), output, errors;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!options.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  posix_spawn_file_actions_adddup2(&actions, input.number(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors.number(), STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::vector<char*> words = pointers(command);
  const std::vector<std::string> variables = options.as_started ? first_environment() : std::vector<std::string>();
  std::vector<char*> started_with = pointers(variables);
  pid_t process = 0;
  ProcessEnd end;
  end.found = posix_spawnp(&process, words[0], &actions, &attributes, words.data(),
                           options.as_started ? started_with.data() : environ) == 0;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (!end.found) return end;
  wait_for(process, options, end);
  end.output = output.content();
  end.errors = errors.content();
  return end;
}

}  // namespace toile::base
