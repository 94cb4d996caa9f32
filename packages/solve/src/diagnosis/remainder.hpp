#pragma once

#include <vector>

#include "diagnosis/softest_motion.hpp"

namespace toile::solve {

/// What an attempt at an equilibrium left unsolved. The same on every rank.
struct Remainder {
  std::vector<Vec3> force;      ///< [cluster] N, what does not balance in the free directions
  std::vector<double> opening;  ///< [cluster] mm, violation of contact
  Imbalance total;
  double s = 0.0;                ///< of the stage
  double damping = 0.0;          ///< its coefficient
  int iterations = 0;            ///< Newton's of the attempt
  bool factorised = true;        ///< the last tangent could be factorised
  bool finite = true;            ///< residual and gap are numbers
  std::vector<double> residual;  ///< [iteration] relative force residual on the way
  SoftestMotion softest;         ///< there, if it was looked for
  State state;                   ///< where the attempt gave up
};

/// Evaluates the equilibrium where the attempt ended, with the damping that it had. Collective.
Remainder remainder_of(Equilibrium& equilibrium, const Attempt& attempt, double damping, size_t clusters);

}  // namespace toile::solve
