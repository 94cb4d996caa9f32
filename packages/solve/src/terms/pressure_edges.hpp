#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// [block][element] edges at which a follower pressure ends, as bits: bit i is the edge from corner i to the next one.
/// An edge that elements on both sides load with the same pressure, also across a seam, is none.
std::vector<std::vector<std::uint8_t>> find_pressure_edges(const Problem& problem);

// The force of a pressure p on a panel is p times the gradient of its volume integral V = 1/3 integral of x . n, less p
// times what the edge adds to that gradient: of an edge from a to b (counter-clockwise) g = (b x a)/6 at both ends.

/// What the potential -p V lacks of an edge per pressure, mm^3, to the second order about (a0, b0): the work of g from
/// there to (a, b). Exact where the edge slides in a plane that is held, where g has a potential.
double edge_work(const Vec3& a0, const Vec3& b0, const Vec3& a, const Vec3& b);

/// The symmetric part of the derivative of g at a by b, mm; that at b by a is its transpose, the others are zero. All
/// of it where the edge slides in a plane that is held.
Eigen::Matrix3d edge_stiffness(const Vec3& a, const Vec3& b);

}  // namespace toile::solve
