#pragma once

#include <string>
#include <vector>

#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

/// An accepted step of a damped stage, from parameter `from` to `to`.
struct DampedStep {
  const State &before, &after;
  double from = 0.0, to = 0.0;
  double dissipated = 0.0;  ///< by the damping in this step, N mm
  double energy = 0.0;      ///< strain energy, the largest so far, N mm
};

/// Watches what the damping of a stage does to its path.
///
/// Where equilibria go on, a step dissipates the small share of the energy that is asked for. In a snap to another
/// branch it takes up what the path loses: a dynamic jump. And where steps dissipate that much over a good part of the
/// stage, it is the damping that holds the garment back: its load goes on, and it does not follow.
class DampedWatch {
 public:
  explicit DampedWatch(const StageOptions& stage) : stage_(stage) {}

  /// Returns whether the garment snapped in the step.
  bool accepted(const DampedStep& step);
  /// The snaps are told by something else.
  void leave_snaps() { snaps_.has_largest = false; }
  /// What is to be said of the stage.
  std::vector<std::string> warnings() const;

  const FoundSteps& memory() const { return snaps_; }
  void resume(const FoundSteps& memory) { snaps_ = memory; }

 private:
  bool holds_back() const;
  std::string snap_warning() const;
  std::string frozen_warning() const;

  StageOptions stage_;
  FoundSteps snaps_;
};

}  // namespace toile::solve
