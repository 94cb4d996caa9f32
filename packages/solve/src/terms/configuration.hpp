#pragma once

#include <vector>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// What the unknowns of a stage and its parameter s make of the nodes of one rank.
struct Configuration {
  double s = 0.0;
  double load = 0.0;               ///< at s
  double opening = 0.0;            ///< of the seams at s: 1 as placed, 0 closed
  std::vector<double> master;      ///< [local cluster][3] position of its master, mm
  std::vector<double> x;           ///< [local node][3] mm
  std::vector<double> rotation;    ///< [local node][2] of shells, since the start of the step; empty without shells
  std::vector<double> multiplier;  ///< [owned cluster] contact force, N; empty without a body

  Vec3 position(size_t cluster) const {
    return {master[3 * cluster], master[3 * cluster + 1], master[3 * cluster + 2]};
  }
};

}  // namespace toile::solve
