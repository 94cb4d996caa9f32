#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace toile::base {

/// Estimated time, s: one value, or two where the past does not tell which.
struct TimeLeft {
  double least = 0.0, most = 0.0;
};

/// Where a run stands after an accepted step.
struct ProgressPoint {
  std::string stage;
  int stage_number = 1;  ///< counts from 1
  int stages = 1;
  int step = 0;            ///< counted over the run
  double parameter = 0.0;  ///< of the stage, 0..1
  double load = 0.0;
  int iterations = 0;                           ///< of this step
  double seconds = 0.0;                         ///< since the start of the run
  bool final_state = false;                     ///< the equilibrium that ends the stage
  std::optional<TimeLeft> left = std::nullopt;  ///< to 100 % of the stage
};

/// Estimates when the path of a stage reaches its end, from the steps that it has taken: the time that a unit of the
/// stage's parameter takes, growing on as it grew from the first to the second half of the way so far. What follows
/// (the final state, later stages) is not in it: nothing is known of it. After a step that took far longer
/// than its neighbours (cut-backs) nobody knows what the next ones will take: as long as the easy ones, or as the last.
class PathClock {
 public:
  /// A stage starts now; `seconds` on any clock.
  void start(double seconds);
  /// The stage has reached a parameter (0..1).
  void advance(double parameter, double seconds);
  /// To parameter 1; empty while nothing is known, and where the parameter falls, as on a branch behind a limit point.
  std::optional<TimeLeft> left() const;

 private:
  double seconds_at(double parameter) const;
  std::vector<double> paces() const;
  double by_growth() const;

  std::vector<double> parameter_, seconds_;  ///< [step] since the stage's first equilibrium; where it grew
  bool falls_ = false;                       ///< the parameter is below the largest that was reached
};

/// Tells when a step that takes long is due for a line, so that a run is never silent for long.
class Heartbeat {
 public:
  using Clock = std::function<double()>;  ///< seconds
  /// At most one line in `interval` seconds.
  Heartbeat(double interval, Clock clock) : interval_(interval), clock_(std::move(clock)), last_(clock_()) {}
  /// A line of another kind was printed.
  void line_printed() { last_ = clock_(); }
  /// Whether a line is due; it then counts as printed.
  bool due();

 private:
  double interval_;
  Clock clock_;
  double last_;
};

/// Where a step that is sought stands.
struct IterationPoint {
  std::string stage;
  int stage_number = 1;  ///< counts from 1
  int stages = 1;
  double parameter = 0.0;  ///< that is sought, of the stage, 0..1
  bool relaxing = false;   ///< the equilibrium that ends the stage is sought
  int iteration = 0;
  int cut_backs = 0;      ///< failed attempts since the last accepted step
  double residual = 0.0;  ///< relative
  double tolerance = 0.0;
  double seconds = 0.0;  ///< since the start of the run
};

/// One line: stage, what is sought, iteration, residual, cut-backs and elapsed time.
std::string iteration_line(const IterationPoint& point);

/// One line: stage, step, parameter in percent, load, iterations, elapsed time and estimated time to 100 %.
std::string progress_line(const ProgressPoint& point);

/// "4.2 s", "3 min 05 s", "2 h 07 min".
std::string duration_text(double seconds);

}  // namespace toile::base
