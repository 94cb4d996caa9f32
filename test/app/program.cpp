#include "program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace toile::test {

namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

ProgramTest::ProgramTest() {
  std::string pattern = (fs::temp_directory_path() / "toile-app-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
  folder_ = pattern;
}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Outcome ProgramTest::toile(const std::string& arguments, int ranks) const {
  std::string command = "cd '" + folder_ + "' && ";
  if (ranks > 0)
    command += TOILE_MPIEXEC " --allow-run-as-root --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 -n " +
               std::to_string(ranks) + " ";
  command += "'" TOILE_PROGRAM "' " + arguments + " > out.txt 2> err.txt";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out.txt"), read("err.txt")};
}

void ProgramTest::write_scene(const std::string& name, const Edits& edits) const {
  std::string text = text_of(TOILE_SOURCE_DIR "/test/app/scenes/" + name + ".xml");
  for (const auto& [from, to] : edits) {
    size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << "the scene does not contain " << from;
    for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  }
  write("scene.xml", text);
}

void ProgramTest::write(const std::string& file, const std::string& text) const {
  fs::create_directories(fs::path(path(file)).parent_path());
  std::ofstream(path(file)) << text;
}

std::string ProgramTest::read(const std::string& file) const {
  return text_of(path(file));
}
bool ProgramTest::exists(const std::string& file) const {
  return fs::exists(path(file));
}

std::string summary_line(const std::string& out, const std::string& label) {
  const size_t summary = out.find("\nSummary\n");
  const size_t at = out.find(label, summary == std::string::npos ? 0 : summary);
  if (at == std::string::npos) return "no \"" + label + "\" in the summary";
  const size_t begin = at + label.size();
  return out.substr(begin, out.find('\n', begin) - begin);
}

std::vector<std::string> last_row(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, last;
  while (std::getline(lines, line)) last = line;
  std::vector<std::string> cells;
  std::istringstream stream(last);
  while (std::getline(stream, line, ',')) cells.push_back(line);
  return cells;
}

}  // namespace toile::test
