#pragma once

#include <stdexcept>
#include <string>

namespace toile::base {

/// Exit status of the program, documented in doc/user-guide.md.
enum class ExitCode : int {
  success = 0,         ///< all that was asked for was done, and every check that was asked for held
  internal_error = 1,  ///< a fault of Toile itself
  bad_input = 2,       ///< the command line, the input file or a file that it names is not usable
  solve_failed = 3,    ///< a stage could not reach its end; the last converged state is on disk
  check_failed = 4     ///< all was computed, but a check of the scene's results or of a fabric's energy did not hold
};

/// Error that ends the run with a given exit status. The message is complete: what, where, found, allowed.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The user's input cannot be used as it is.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(ExitCode::bad_input, message) {}
};

/// A solve that could not reach its end.
class SolveError : public Error {
 public:
  explicit SolveError(const std::string& message) : Error(ExitCode::solve_failed, message) {}
};

}  // namespace toile::base
