#pragma once

#include <functional>
#include <memory>

#include "equilibrium/equilibrium.hpp"

namespace toile::solve {

/// How an attempt to reach equilibrium ended.
struct Attempt {
  RCP<Vector> z;  ///< where it ended
  double s;
  bool converged;
  int iterations;         ///< of Newton's method
  Evaluation evaluation;  ///< at z
};

/// Whether what converged at (z, s) in so many iterations counts; empty: everything does.
using AcceptsStep = std::function<bool(const Vector& z, double s, int iterations)>;

/// Newton's method from z at fixed s.
Attempt solve_at(const std::shared_ptr<Equilibrium>& equilibrium, const StageOptions& stage,
                 const NewtonOptions& options, const Vector& z, double s, const AcceptsStep& accepts = {});

}  // namespace toile::solve
