#pragma once

#include "assumed_shear.hpp"

namespace toile::element {

/// Assumed transverse shear of the four-node shells (MITC4: Bathe and Dvorkin, Int. J. Numer. Methods Engrg. 21 (1985)
/// 367-383): sampled at the middle of the four edges, each component linear between opposite edges; at the points of
/// bilinear().
ShearSampling<4, 4, 4> mitc4();

}  // namespace toile::element
