#pragma once

#include <string>

#include "toile/base/parameters.hpp"
#include "toile/mesh/four_sided.hpp"

namespace toile::garment {

/// One flat piece of fabric, meshed in its pattern.
struct Panel {
  std::string name;
  std::string material;     ///< name of the entry of "Materials"
  double wale_angle = 0.0;  ///< radians from the pattern's x axis
  mesh::Grid grid;          ///< mm
};

/// Description of the list "Panels": one entry a panel, with its shape, mesh and placement.
base::Spec panels_spec();

/// Meshes one entry of "Panels". Throws InputError, with the place in the pattern, for an outline that is open, crosses
/// itself or runs clockwise, and for a shape whose elements fold over.
Panel build_panel(const base::List& entry);

}  // namespace toile::garment
