#pragma once

#include <cmath>

namespace toile::criteria {

/// An eigenvalue below zero by less than this part of the largest is zero.
inline constexpr double rounding = 1e-9;
inline const double pi = std::acos(-1.0);

}  // namespace toile::criteria
