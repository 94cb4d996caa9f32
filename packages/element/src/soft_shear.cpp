#include "soft_shear.hpp"

#include <algorithm>

#include "uniaxial_moduli.hpp"
#include "vector.hpp"

namespace toile::element {
namespace {

/// Of cantilevers and the hemisphere of Sze, Liu and Lo, see theory.md.
constexpr double relief = 0.05;

}  // namespace

// Slack fibres may leave no uniaxial modulus at rest; what holds the shear in the plane holds it then.
void SoftShear::freeze(const double (&natural)[6], double* frozen) {
  double modulus[2];
  uniaxial_moduli(natural, modulus);
  for (int a = 0; a < 2; ++a) frozen[a] = std::max(modulus[a], natural[2]);
}

void SoftShear::soften(const double (&X)[3][3], double thickness, const double* frozen, double (&stiffness)[2]) {
  double longest = 0.0;  // squared
  for (int i = 0; i < 3; ++i) {
    double edge[3];
    for (int c = 0; c < 3; ++c) edge[c] = X[(i + 1) % 3][c] - X[i][c];
    longest = std::max(longest, dot(edge, edge));
  }
  for (int a = 0; a < 2; ++a) {
    const double bending = frozen[a] * thickness * thickness * thickness / 12.0;
    stiffness[a] *= bending / (bending + relief * longest * stiffness[a]);
  }
}

}  // namespace toile::element
