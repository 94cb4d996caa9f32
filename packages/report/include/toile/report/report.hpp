#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace toile::report {

struct Options {
  /// Bytes above which fields that explain others (stresses, the parts of an error) are left out.
  std::size_t most_bytes = 15'000'000;
};

/// What was written.
struct Written {
  std::size_t bytes = 0;
  std::vector<std::string> left_out;  ///< fields, for the file's size
};

/// False in a build without reports (TOILE_ENABLE_REPORT=OFF): write_report() then throws base::InputError.
bool available();

/// Writes `page`, one HTML file that needs nothing else: the last state in `results` (a results.exo or start.exo) in
/// 3-D, its steps, and what lies beside it: the tables (*.csv) and the record of the run (run.json). A record that is
/// missing or of another state is a warning in the page. The page takes the place of an older one when it is complete.
/// Throws base::InputError if `results` cannot be read (result::read_results), a file beside it cannot, or the page
/// cannot be written.
Written write_report(const std::string& results, const std::string& page, const Options& options = {});

}  // namespace toile::report
