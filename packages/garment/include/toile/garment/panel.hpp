#pragma once

#include <optional>
#include <string>

#include "toile/base/parameters.hpp"
#include "toile/garment/shell.hpp"
#include "toile/mesh/four_sided.hpp"

namespace toile::garment {

/// One flat piece of fabric, meshed in its pattern.
struct Panel {
  std::string name;
  std::string material;               ///< name of the entry of "Materials"
  double wale_angle = 0.0;            ///< radians from the pattern's x axis
  mesh::Grid grid;                    ///< mm
  std::optional<ShellOptions> shell;  ///< none: a membrane
};

/// Description of the list "Panels": one entry a panel, with its shape, mesh and placement.
base::Spec panels_spec();

/// Meshes one entry of "Panels". Throws InputError, with the place in the pattern, for an outline that is open, crosses
/// itself or runs clockwise, for a shape whose elements fold over, and
/// for shell options that do not go together.
Panel build_panel(const base::List& entry);

}  // namespace toile::garment
