#pragma once

#include <functional>
#include <memory>

#include "equilibrium.hpp"

namespace toile::solve {

/// How an attempt to reach equilibrium ended.
struct Attempt {
  RCP<Vector> z;  ///< where it ended
  double s;
  bool converged;
  int iterations;       ///< of Newton's method
  Imbalance imbalance;  ///< at z
};

/// Newton's method from z at fixed s.
Attempt solve_at(const std::shared_ptr<Equilibrium>& equilibrium, const StageOptions& stage,
                 const NewtonOptions& options, const Vector& z, double s);

/// What a stage has to say to the steps on its path.
struct PathHooks {
  /// Whether a step that converged at (z, s) counts; if not, it is cut back. Empty: all do.
  std::function<bool(const Vector& z, double s, int iterations)> accepts;
  /// Called at each attempt; the first is the equilibrium at s = 0. False: the path ends here.
  std::function<bool(const Attempt&)> report;
};

/// LOCA's continuation from (z, 0) towards s = 1, natural or pseudo-arc-length, with cut-backs. `tangent_first`: the
/// first step is predicted along the tangent.
void follow_path(const std::shared_ptr<Equilibrium>& equilibrium, const StageOptions& stage,
                 const NewtonOptions& options, bool tangent_first, const Vector& z, const PathHooks& hooks);

}  // namespace toile::solve
