#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <set>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/material/plugin_files.hpp"
#include "toolchain.hpp"

namespace toile::material {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words command_of(const std::string& source, const std::string& library) {
  const Toolchain& own = toolchain();
  Words command = {own.compiler};
  command.insert(command.end(), own.flags.begin(), own.flags.end());
  for (const char* flag : {"-fPIC", "-shared", "-fvisibility=hidden", "-fvisibility-inlines-hidden", "-w",
                           "-fmax-errors=5", "-fdiagnostics-color=never"})
    command.emplace_back(flag);
  for (const std::string& folder : own.include_folders) command.insert(command.end(), {"-isystem", folder});
  command.push_back("-DTOILE_MATERIAL_VERSION=\"" + own.version + "\"");
  command.insert(command.end(), {"-o", library, source});
  return command;
}

/// The words as one line for a shell.
std::string shell_text(const Words& command) {
  std::string line;
  for (const std::string& word : command) {
    const bool plain = word.find_first_of(" \"'\\$&;()<>|*?`") == std::string::npos;
    line += (line.empty() ? "" : " ") + (plain ? word : "'" + word + "'");
  }
  return line;
}

/// Runs the command without a shell; returns its exit status (-1: ended by a signal) and what it said on both streams.
std::pair<int, std::string> run(const Words& command) {
  std::array<int, 2> ends = {};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw base::Error(base::ExitCode::internal_error, "no pipe to the compiler can be made");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::string said;
  std::array<char, 4096> buffer = {};
  for (ssize_t n = 0; failure == 0 && (n = read(ends[0], buffer.data(), buffer.size())) > 0;)
    said.append(buffer.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  if (failure != 0)
    throw base::InputError("the compiler that Toile was built with, " + command.front() + ", cannot be run");
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said};
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// `line` with the type `name`<...> named `plain`, however long its arguments are.
void shorten(std::string& line, const std::string& name, const std::string& plain) {
  for (auto at = line.find(name + "<"); at != std::string::npos; at = line.find(name + "<", at + 1)) {
    auto end = at + name.size();
    int depth = 0;
    do {
      depth += (line[end] == '<') - (line[end] == '>');
      ++end;
    } while (depth > 0 && end < line.size());
    line.replace(at, end - at, plain);
  }
}

/// Types as the author wrote them.
void shorten_types(std::string& line) {
  shorten(line, "toile::material::PlaneC", "PlaneC<T>");
  shorten(line, "toile::material::Params", "Params<P>");
  shorten(line, "Sacado::Fad::Exp::GeneralFad", "T");
}

/// The errors alone, each place once, with the lines of code that the compiler shows. Where one lies in a header, the
/// place in the author's file that led to it goes before it, and the header's name is dropped.
std::string first_errors(const std::string& said, const std::string& source) {
  std::istringstream lines(said);
  std::string text, place;
  std::set<std::string> shown;
  bool shows_code = false;
  for (std::string line; std::getline(lines, line);) {
    const bool own = starts_with(line, source + ":");
    const auto error = std::min(line.find(" error: "), line.find(" fatal error: "));
    if (error != std::string::npos) {
      const std::string where = own ? line.substr(0, error) : place.empty() ? source + ":" : place;
      const bool is_new = shown.insert(where).second;
      line = where + line.substr(error);
      shorten_types(line);
      if (is_new) text += line + "\n";
      shows_code = own && is_new;
    } else if (!line.empty() && line.front() == ' ' && shows_code && line.find('|') != std::string::npos) {
      text += line + "\n";
    } else {
      shows_code = false;
      if (own) place = line.substr(0, line.find(' '));
    }
  }
  return text.empty() ? said : text;
}

}  // namespace

PlugInBuild build_plugin(const std::string& source, const std::string& library, bool verbose) {
  if (!fs::is_regular_file(source)) throw base::InputError(source + ": there is no such file");
  for (const std::string& folder : toolchain().include_folders)
    if (!fs::is_directory(folder))
      throw base::InputError("the headers of Toile that a plug-in is compiled with are not there: no folder " + folder);
  const Words command = command_of(source, library);
  auto [status, said] = run(command);
  PlugInBuild build{status == 0, shell_text(command), ""};
  build.messages = verbose || build.good ? said : first_errors(said, source);
  return build;
}

}  // namespace toile::material
