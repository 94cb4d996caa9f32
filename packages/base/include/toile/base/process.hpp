#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace toile::base {

/// What a program that was run left.
struct ProcessEnd {
  bool found = true;                              ///< the program exists
  bool out_of_time = false;                       ///< it was ended after the limit
  bool stopped = false;                           ///< it was ended because that was wanted
  double seconds = 0.0, processor_seconds = 0.0;  ///< wall time; of all threads and of what it started itself
  int status = 0;                                 ///< exit status; -1: ended by a signal
  int signal = 0;                                 ///< that ended it; 0: none
  std::string output;                             ///< of its standard output
  std::string errors;                             ///< of its standard error
};

struct ProcessOptions {
  std::string input;   ///< on its standard input
  std::string folder;  ///< that it runs in; empty: this one
  double most_seconds = std::numeric_limits<double>::infinity();
  /// With the environment that this program was started with: MPI puts into its own what makes the next one a part of
  /// it.
  bool as_started = false;
  std::function<bool()> stop = {};  ///< asked again and again: true ends it
};

/// Runs a program without a shell, in a process group of its own that ends with it, and waits for its end.
ProcessEnd run_process(const std::vector<std::string>& command, const ProcessOptions& options = {});

}  // namespace toile::base
