#pragma once

#include <set>
#include <string>

#include "layout.hpp"

namespace toile::solve {

/// What the supports hold that are not `released`: positions, all rotations of a clamp, and those out of a plane of
/// symmetry. Throws base::InputError if two supports move the same node differently.
Held held_by_supports(const Problem& problem, const State& state, const std::set<std::string>& released);

}  // namespace toile::solve
