#pragma once

#include <array>

namespace toile::element {

/// Principal Cauchy stresses (MPa, larger first) of a plane-stress point with C and S in the order 11, 22, 12 (S in
/// MPa) and thickness stretch h/h0.
std::array<double, 2> principal_cauchy(const double (&C)[3], const double (&S)[3], double thickness_stretch);

}  // namespace toile::element
