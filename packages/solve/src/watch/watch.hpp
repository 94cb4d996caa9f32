#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "equilibrium/types.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::solve {

/// Follows a run from one iteration to the next: tells its observer, and ends the stage where a limit of time is
/// reached or somebody wants it to end. All ranks decide alike.
class Watch {
 public:
  Watch(RCP<const Comm> comm, double most_time);

  void observe(IterationObserver observer) { observer_ = std::move(observer); }
  /// `wanted`: empty, or why the run is to end; asked on every rank after each iteration.
  void stop_when(std::function<std::string()> wanted) { wanted_ = std::move(wanted); }

  void start_stage(const StageOptions& stage);
  /// The attempts that follow belong to the search for the stage's undamped end.
  void set_relaxing(bool relaxing) { report_.relaxing = relaxing; }
  void set_cut_backs(int cut_backs) { report_.cut_backs = cut_backs; }

  /// After an iteration at s. Collective. False: give up.
  bool go_on(int iteration, double s, double residual, double gap);
  /// Since the stage began.
  int iterations() const { return iterations_; }
  void set_iterations(int iterations) { iterations_ = iterations; }
  /// [iteration] relative force residuals of the last attempt.
  const std::vector<double>& residuals() const { return residuals_; }
  /// The stage ends here.
  void stop(const std::string& reason) { stopped_ = reason; }
  /// Why the stage has to end before its time, or empty.
  const std::string& stopped() const { return stopped_; }

 private:
  double now() const;
  void find_reason();

  RCP<const Comm> comm_;
  IterationObserver observer_;
  std::function<std::string()> wanted_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double most_time_;  ///< of the run, s; 0: no limit
  double stage_most_time_ = 0.0, stage_start_ = 0.0;
  int stage_most_iterations_ = 0, iterations_ = 0;
  IterationReport report_;
  std::vector<double> residuals_;
  std::string stopped_;
};

}  // namespace toile::solve
