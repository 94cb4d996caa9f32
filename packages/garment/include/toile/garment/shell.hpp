#pragma once

#include <optional>

#include "toile/base/parameters.hpp"

namespace toile::garment {

/// How a panel is computed as a shell.
struct ShellOptions {
  bool reduced = false;  ///< one integration point in the plane instead of 2 x 2 (triangles have one rule only)
  int layers = 3;        ///< integration points through the thickness
  std::optional<double> shear_modulus;  ///< transverse, MPa; none: the material's
  double shear_correction = 5.0 / 6.0;  ///< factor of the transverse shear stiffness
  bool placed_is_stress_free = false;   ///< the placed shape is free of stress, not the flat pattern
};

/// Description of the list "Shell" of a panel.
base::Spec shell_spec();

/// Options of one entry of "Panels"; none if it has no list "Shell" and is a membrane. Throws InputError.
std::optional<ShellOptions> read_shell(const base::List& panel);

}  // namespace toile::garment
