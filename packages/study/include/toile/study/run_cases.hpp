#pragma once

#include <functional>
#include <string>
#include <vector>

#include "toile/study/study.hpp"

namespace toile::study {

/// How the program ended on one case.
struct Outcome {
  int status = 0;  ///< of the program; -1: ended by a signal
  int signal = 0;
  bool out_of_time = false;
  bool known = false;    ///< from an earlier run of the study
  std::string reason;    ///< why it has no result; empty if it has
  base::Texts warnings;  ///< what the run says that limits the trust in its result
  double seconds = 0.0, processor_seconds = 0.0;
};

struct RunOptions {
  std::string program;   ///< its path
  std::string identity;  ///< its version: cases that another one has run are run again
  std::string folder;    ///< of the study's results; each case has a folder in it
  bool allow_plugins = false;
  std::function<bool()> stop = {};                             ///< true: no further case
  std::function<void(const Case&, const Outcome&)> tell = {};  ///< one at a time, as cases end
};

/// Runs every case as a process of its own: writes case.xml into its folder, runs it there, and keeps how it ended in
/// case.json. A case that ended before with the same scene, files and program is not run again. [case]. Throws
/// base::InputError if a folder cannot be written, base::SolveError if it was stopped: what has ended is kept.
std::vector<Outcome> run_cases(const Study& study, const RunOptions& options);

}  // namespace toile::study
