#pragma once

#include "nodal_system.hpp"
#include "shell_point.hpp"

namespace toile::element {

/// For an element whose points leave no deformation without energy.
struct NoStabilisation {
  static constexpr int frozen_values = 0;
  static constexpr bool has_energy = false;
  static constexpr bool softens_shear = false;
};

/// Physical stabilisation of a quadrilateral with one in-plane point.
///
/// A bilinear field is x = x_c + a_1 X_1 + a_2 X_2 + q h with h = xi eta and q = sum_I Gamma_I x_I, Gamma orthogonal to
/// linear fields. Of the strain that q adds, the assumed strain keeps the normal parts (a_a.q) h_,a and drops the shear
/// (quintessential bending: Belytschko and Bachrach, Comput. Methods Appl. Mech. Engrg. 54 (1986) 279-301), of the
/// change of curvature likewise (a_a.q_d + d_a.q) h_,a. Their energy is taken with uniaxial moduli and stress that are
/// frozen at the start of a step, so that the step has a potential. Transverse shear holds the mode out of the plane.
class Hourglass {
 public:
  /// Moduli along the two axes, and S11, S22, S12 (positive semidefinite part), MPa.
  static constexpr int frozen_values = 5;
  static constexpr bool has_energy = true;
  static constexpr bool softens_shear = false;
  /// `S`, `D`: at the centre; `natural`: D of the undeformed material, of which the moduli keep a hundredth at least.
  static void freeze(const double (&S)[3], const double (&D)[6], const double (&natural)[6], double* frozen);

  void set_reference(const ShellNodes<4>& nodes, const ReferencePoint<4> (&points)[4], const ShellPoint<4>& centre,
                     double thickness, const double* frozen);
  void deform(const ShellNodes<4>& nodes, const ShellPoint<4>& centre);
  double energy() const;
  void add_force(NodalSystem<4>& system) const;
  void add_stiffness(NodalSystem<4>& system) const;

 private:
  void set_slopes(const ShellPoint<4>& centre);

  double gamma_[4];
  double g_[2][4];                        ///< gradients at the centre
  double stiffness_[2], bending_[2];      ///< of the assumed strains along the axes
  double geometric_, geometric_bending_;  ///< of q.q and q_d.q_d
  double reference_strain_[2];            ///< change of curvature that the reference has already
  double reference_squared_, reference_bending_squared_;
  double l_;
  double q_[3], q_d_[3];  ///< of positions, and of directors times l
  double strain_[2], curvature_[2];
  double strain_slope_[2][4][3];     ///< by x_I
  double curvature_slope_[2][4][6];  ///< by (x_I, d_I)
};

}  // namespace toile::element
