#pragma once

#include <string>

#include "diagnosis/remainder.hpp"
#include "equilibrium/held.hpp"

namespace toile::solve {

/// Everything that is known of a stage that fails; the same on every rank.
struct Failure {
  const Problem& problem;
  const StageOptions& stage;
  const NewtonOptions& newton;
  const Held& held;
  const State& start;     ///< of the stage
  const State& last;      ///< last converged state of the stage, or its start
  const Remainder& left;  ///< of the last attempt
  double reached;         ///< s of the last accepted step
  bool stepped;           ///< a step of the stage was accepted
  bool relaxing;          ///< its undamped end was sought
  int cut_backs;          ///< since the last accepted step
};

/// What did not converge, and where: how the last attempt ended, residual and gap against their tolerances, the worst
/// node or material point with its panel, place and seam; where the tangent is singular, or not stable, the node that
/// moves most in the softest motion.
std::string what_failed(const Failure& failure);

/// The likely cause and a way out: of causes() the first that applies, else what can be tried.
std::string likely_cause(const Failure& failure);

/// Where body and loads push a part of the garment that no support holds: into that direction there is no equilibrium.
/// Empty: nowhere.
std::string unheld_motion(const Failure& failure);

/// Where the garment has moved farthest in the stage, and how, for one that was stopped on its way. Empty: it stands.
std::string farthest_motion(const Failure& failure);

/// A cause: empty where it does not apply. In causes.cpp, which has the table of them.
using Cause = std::string (*)(const Failure&);
const std::vector<Cause>& causes();

}  // namespace toile::solve
