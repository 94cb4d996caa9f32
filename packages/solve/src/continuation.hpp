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

/// LOCA's continuation from (z, 0) towards s = 1, natural or pseudo-arc-length, with cut-backs. `tangent_first`: the
/// first step is predicted along the tangent. Each attempt is reported; the first is the equilibrium at s = 0.
void follow_path(const std::shared_ptr<Equilibrium>& equilibrium, const StageOptions& stage,
                 const NewtonOptions& options, bool tangent_first, const Vector& z,
                 const std::function<void(const Attempt&)>& report);

}  // namespace toile::solve
