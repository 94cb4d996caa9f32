#include "principal_stress.hpp"

#include <cmath>

namespace toile::element {

// The Cauchy stress F S F^T / J has the eigenvalues of the symmetric matrix U S U / J, with U = sqrt(C) in closed form
// and J = h/h0 sqrt(det C).
std::array<double, 2> principal_cauchy(const double (&C)[3], const double (&S)[3], double thickness_stretch) {
  const double root = std::sqrt(C[0] * C[1] - C[2] * C[2]);
  const double scale = 1.0 / std::sqrt(C[0] + C[1] + 2.0 * root);
  const double U11 = (C[0] + root) * scale, U22 = (C[1] + root) * scale, U12 = C[2] * scale;
  const double V11 = U11 * S[0] + U12 * S[2], V12 = U11 * S[2] + U12 * S[1];
  const double V21 = U12 * S[0] + U22 * S[2], V22 = U12 * S[2] + U22 * S[1];
  const double J = thickness_stretch * root;
  const double s11 = (V11 * U11 + V12 * U12) / J, s22 = (V21 * U12 + V22 * U22) / J;
  const double s12 = (V11 * U12 + V12 * U22) / J;
  const double mean = 0.5 * (s11 + s22), radius = std::hypot(0.5 * (s11 - s22), s12);
  return {mean + radius, mean - radius};
}

}  // namespace toile::element
