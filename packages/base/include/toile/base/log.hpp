#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace toile::base {

/// What a run tells its user. One object a run, made by the program and handed to those who report.
/// Only the rank that is to print has a stream; the calls are the same on every rank and communicate nothing.
class Log {
 public:
  /// Information goes to `out`, warnings to `err`. `quiet`: no information; warnings are still printed.
  /// The streams must outlive the log.
  Log(std::ostream& out, std::ostream& err, bool quiet = false);
  /// A log that prints nothing, for ranks other than 0.
  Log() = default;

  /// One line of information.
  void info(const std::string& line);
  /// A warning is printed the first time it is given and kept for the summary.
  void warn(const std::string& message);
  /// Text that is overwritten by the next call (progress on a terminal); an empty text ends the line.
  void overwrite(const std::string& line);

  const std::vector<std::string>& warnings() const { return warnings_; }
  bool prints() const { return out_ != nullptr; }

 private:
  void end_overwrite();

  std::ostream* out_ = nullptr;
  std::ostream* err_ = nullptr;
  std::vector<std::string> warnings_;
  std::size_t overwritten_ = 0;  ///< length of the line that stands on the terminal
};

}  // namespace toile::base
