// Runs the program as its user does: as a child process, in a folder of its own.
#pragma once

#include <gmock/gmock.h>

#include <string>
#include <utility>
#include <vector>

namespace toile::test {

struct Outcome {
  int status = -1;  ///< exit status
  std::string out, err;
};

using Edits = std::vector<std::pair<std::string, std::string>>;

/// A test in a temporary folder, which is the working folder of the programs that it runs.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  /// `toile <arguments>`; with `ranks` > 0 under mpirun. The arguments are for a shell.
  Outcome toile(const std::string& arguments, int ranks = 0) const;
  /// Copies scenes/<name>.xml to scene.xml with each text (which must be there) replaced wherever it stands.
  void write_scene(const std::string& name, const Edits& edits = {}) const;
  void write(const std::string& file, const std::string& text) const;
  std::string read(const std::string& file) const;
  bool exists(const std::string& file) const;
  std::string path(const std::string& file) const { return folder_ + "/" + file; }

 private:
  std::string folder_;
};

/// The rest of the line after `label` in a summary.
std::string summary_line(const std::string& out, const std::string& label);

/// Cells of the last row of a table.
std::vector<std::string> last_row(const std::string& csv);

}  // namespace toile::test
