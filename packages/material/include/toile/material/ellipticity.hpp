#pragma once

#include <array>

namespace toile::material {

/// Strong ellipticity of a plane-stress energy W(F) at one state: its acoustic tensor
///   Q_ik(n) = d2W/dF_ia dF_kb n_a n_b,   n a unit vector of the reference,
/// in the plane of the fabric. Where an eigenvalue is negative for some n, folding or sliding along the lines across n
/// takes less energy than a smooth deformation: results there depend on the mesh (Marsden and Hughes, Mathematical
/// Foundations of Elasticity (1983), section 3.4; Rice, The Localization of Plastic Deformation (1976)). Out of the
/// plane the eigenvalue is n.S.n; negative, the fabric wrinkles, which is another matter.
struct Ellipticity {
  double smallest;                  ///< eigenvalue over all n, MPa
  double largest;                   ///< eigenvalue over all n, MPa (to some thousandths)
  std::array<double, 2> direction;  ///< n of the smallest: wale and course component, unit length

  /// Whether an eigenvalue is negative beyond rounding; `tolerance`: of the largest. False where it is not a number.
  bool is_lost(double tolerance = 1e-9) const { return smallest < -tolerance * largest; }
};

/// C (C11, C22, C12), S (MPa) and D (MPa) as a Response gives them, in the order of LawV1. The direction is found
/// to 1e-8 rad.
Ellipticity ellipticity(const std::array<double, 3>& C, const std::array<double, 3>& S, const std::array<double, 6>& D);

/// True only where no eigenvalue is negative whatever C is: a quick sufficient condition (S and D positive definite),
/// which a fabric in tension usually meets.
bool is_surely_elliptic(const std::array<double, 3>& S, const std::array<double, 6>& D);

}  // namespace toile::material
