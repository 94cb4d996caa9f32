#pragma once

namespace toile::element {

/// Transverse shear of a triangle whose curvature is constant.
///
/// Where the mesh is coarser than the shell is thick, three edges without shear leave such a triangle too few ways to
/// bend. What it cannot bend within itself is made up for by a compliance in shear that goes with the bending
/// compliance: 1/k_a = 1/(G h0) + relief L^2/(E_a h0^3/12), L the longest edge of the reference, E_a the uniaxial
/// modulus along the material axis a. An error of the order of the mesh size squared, whatever the moduli.
class SoftShear {
 public:
  /// E_a of the undeformed material along the two axes, MPa.
  static constexpr int frozen_values = 2;
  static constexpr bool has_energy = false;
  static constexpr bool softens_shear = true;
  /// `natural`: D of the undeformed material.
  static void freeze(const double (&natural)[6], double* frozen);
  /// Adds to the stiffness G h0 (N/mm) what the bending of the element brings.
  static void soften(const double (&X)[3][3], double thickness, const double* frozen, double (&stiffness)[2]);
};

}  // namespace toile::element
