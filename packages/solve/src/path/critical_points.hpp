#pragma once

#include <string>

#include "equilibrium/equilibrium.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

/// Counts the negative pivots of the tangent at accepted states, and tells a critical point that lies between two of
/// them.
class CriticalPoints {
 public:
  /// The equations of a stage begin at z: nothing is counted yet.
  void start(RCP<const Vector> z);
  /// Sets `negative_pivots` and `critical` in the report of the accepted state (z, s). The tangent is taken without
  /// damping, which would hide an instability. Returns what was passed since the last count; empty: nothing.
  /// `arc_length`: limit points and bifurcations can be told apart.
  std::string count(Equilibrium& equilibrium, const Vector& z, double s, bool arc_length, StepReport& report);

  PivotMemory memory(const Equilibrium& equilibrium) const;
  void resume(const PivotMemory& memory, const Equilibrium& equilibrium);

 private:
  int pivots_ = -1;  ///< of the last count; -1: not known
  double load_ = 0.0, s_ = 0.0;
  double direction_ = 1.0;  ///< in which the path went on in s
  RCP<const Vector> z_;
};

/// What is to be said of the stability of a stage's final state; empty: it is stable.
std::string stability_warning(const StepReport& last);

}  // namespace toile::solve
