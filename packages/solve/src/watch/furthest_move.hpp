#pragma once

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// The point that moves furthest between two states.
struct FurthestMove {
  double distance = 0.0;   ///< mm
  Vec3 at = Vec3::Zero();  ///< before
};

inline FurthestMove furthest_move(const State& before, const State& after) {
  FurthestMove furthest;
  for (size_t c = 0; c < after.position.size(); ++c) {
    const double moved = (after.position[c] - before.position[c]).norm();
    if (moved > furthest.distance) furthest = {moved, before.position[c]};
  }
  return furthest;
}

}  // namespace toile::solve
