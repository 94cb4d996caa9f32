#pragma once

#include "toile/solve/checkpoint.hpp"
#include "watch/furthest_move.hpp"

namespace toile::solve {

/// Counts a step, and keeps it if it is the largest so far; `distance` and `at` as in FoundSteps.
inline void count_step(FoundSteps& found, double from, double to, bool is_largest, const FurthestMove& move) {
  if (++found.count == 1) found.first = from;
  found.end = to;
  if (!is_largest) return;
  found.has_largest = true;
  found.from = from;
  found.to = to;
  found.distance = move.distance;
  found.at = move.at;
}

}  // namespace toile::solve
