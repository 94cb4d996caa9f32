#pragma once

#include <string>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// What is to be said where the fabric of a state has reached the end of its law, material::stretch_floor: the worst
/// place and its stretch; empty: it has not. Looks at the whole garment on the calling rank.
std::string law_floor_text(const Problem& problem, const State& state);

}  // namespace toile::solve
