#pragma once

#include <algorithm>

namespace toile::element {

/// Uniaxial moduli of plane stress along the two axes from D in the order 11, 22, 33, 12, 13, 23; zero if not positive.
inline void uniaxial_moduli(const double (&D)[6], double (&modulus)[2]) {
  modulus[0] = D[1] > 0.0 ? std::max(D[0] - D[3] * D[3] / D[1], 0.0) : 0.0;
  modulus[1] = D[0] > 0.0 ? std::max(D[1] - D[3] * D[3] / D[0], 0.0) : 0.0;
}

}  // namespace toile::element
