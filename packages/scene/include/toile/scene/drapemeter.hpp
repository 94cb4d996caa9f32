#pragma once

#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::scene {

/// A round piece of fabric that a smaller disc holds in its middle, lit along the axis: Cusick, The measurement of
/// fabric drape, J. Textile Inst. 59 (1968); ISO 9073-9.
struct Drapemeter {
  double disc_radius = 0.0;    ///< mm
  double fabric_radius = 0.0;  ///< mm

  /// Of the shadow's area, the disc's included, mm^2: 1 if the fabric stays flat, 0 if it hangs straight down.
  double coefficient(double shadow) const;
};

/// Along which light falls; the direction may have any length.
struct LightAxis {
  mesh::Vec3 point = mesh::Vec3::Zero();  ///< mm
  mesh::Vec3 direction = mesh::Vec3::UnitZ();
};

base::Spec drapemeter_spec();
/// Throws base::InputError if the garment, as it is placed, is neither a flat disc of fabric round the axis nor the
/// ring of it beyond the disc.
Drapemeter read_drapemeter(const base::List& list, const mesh::Mesh& mesh, const LightAxis& axis);

}  // namespace toile::scene
