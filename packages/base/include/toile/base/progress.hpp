#pragma once

#include <optional>
#include <string>

namespace toile::base {

/// Where a run stands after an accepted step.
struct ProgressPoint {
  std::string stage;
  int stage_number = 1;  ///< counts from 1
  int stages = 1;
  int step = 0;            ///< counted over the run
  double parameter = 0.0;  ///< of the stage, 0..1
  double load = 0.0;
  int iterations = 0;        ///< of this step
  double seconds = 0.0;      ///< since the start of the run
  bool final_state = false;  ///< the equilibrium that ends the stage
};

/// Time that is left, s: what the run took so far, extended at the same speed in the stages' parameters. Empty while
/// nothing is known (parameter 0 of the first stage).
std::optional<double> time_left(const ProgressPoint& point);

/// One line: stage, step, parameter in percent, load, iterations, elapsed time and estimated time left.
std::string progress_line(const ProgressPoint& point);

/// "4.2 s", "3 min 05 s", "2 h 07 min".
std::string duration_text(double seconds);

}  // namespace toile::base
