#pragma once

#include <string>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// Four digits of a number in a message.
std::string number_text(double x);

/// "at (1, 2, 3) mm, in the pattern at (1, 2) mm".
std::string place_text(const Vec3& position, const mesh::Vec2& pattern);

/// `node 12 of panel "front", at (1, 2, 3) mm, in the pattern at (1, 2) mm, on the seam "side"`: the first node of a
/// cluster. Nodes count from 1, as in the results.
std::string node_text(const Problem& problem, const State& state, size_t cluster);

/// "(0, 0, 1)", three digits.
std::string direction_text(const Vec3& direction);

/// Name of the panel that has a node.
std::string panel_of(const Problem& problem, int node);

}  // namespace toile::solve
