#pragma once

#include <string>

#include "watch/last_step.hpp"

namespace toile::solve {

/// Watches a stage of arc length for steps that turn off: onto another branch, or back along the path that they came.
///
/// An arc step ends in the plane across the path's direction, at its own length along it. What is far off in that plane
/// is a sharp bend, which shorter steps round off, or another branch, which they miss.
class ArcWatch {
 public:
  ArcWatch(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage);

  /// Whether the step that converged at (z, s) counts. False: a shorter one is to be tried.
  bool accepts(const Vector& z);
  /// A step was accepted there. Returns whether it turned off, although it was short.
  bool accepted(const Vector& z, double s);
  /// What is to be said of the stage's turns; empty: there are none.
  std::string warning() const;

  WatchMemory memory() const;
  void resume(const WatchMemory& memory);

 private:
  double turn(const Vector& step) const;

  std::shared_ptr<Equilibrium> equilibrium_;
  StageOptions stage_;
  LastStep last_;
  double first_length_ = 0.0;  ///< of the first step, mm
  double off_ = 0.0;           ///< turn of the step that `accepts` let pass although it is large, degrees
  FoundSteps turns_;
};

}  // namespace toile::solve
