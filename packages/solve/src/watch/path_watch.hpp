#pragma once

#include <memory>
#include <string>

#include "path/continuation.hpp"
#include "watch/last_step.hpp"

namespace toile::solve {

/// Watches a stage that goes step by step in the load, and finds the steps that leave the path of equilibria for
/// another branch.
///
/// A step that needs many iterations, or ends far from where the path pointed, is suspect. It is proven by the way
/// back: from its end to the load at which it began. On the same branch that leads to where the step began; from
/// another branch it does not, because that one goes on below the load at which it was entered (hysteresis). A step
/// that goes ten times as far as the path points before it and after it is a jump however it is short.
class PathWatch {
 public:
  PathWatch(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage, const NewtonOptions& options);

  /// Whether the step that converged at (z, s) counts. False: it is a jump, or may be one, and a shorter step may still
  /// follow the path.
  bool accepts(const Vector& z, double s, int iterations);
  /// A step was accepted at (z, s). Returns whether it is a jump.
  bool accepted(const Vector& z, double s);
  /// What is to be said of the stage's jumps; empty: there are none.
  std::string warning() const;

  WatchMemory memory() const;
  void resume(const WatchMemory& memory);

 private:
  /// How far (z, s) lies from where the last secant points, over the length of the predicted step; 0: not known.
  double bend(const Vector& z, double s) const;
  bool leaps(const Vector& z, double s, double off);
  bool returns(const Vector& z, double s);
  /// False: the garment did not move, which is no jump.
  bool note(const Vector& z, double s);

  std::shared_ptr<Equilibrium> equilibrium_;
  StageOptions stage_;
  NewtonOptions options_;
  RCP<const Vector> start_;  ///< of the stage
  LastStep last_;            ///< not known before the stage's start
  bool left_ = false;
  FoundSteps jumps_;
};

}  // namespace toile::solve
