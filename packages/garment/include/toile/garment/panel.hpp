#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/garment/shell.hpp"
#include "toile/mesh/panel_mesh.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::garment {

/// One flat piece of fabric, meshed in its pattern.
struct Panel {
  std::string name;
  std::map<std::string, mesh::ZoneFabric> fabrics;  ///< by zone; empty: outside of all zones
  mesh::PanelMesh mesh;                             ///< mm
  std::optional<ShellOptions> shell;                ///< none: a membrane
  std::optional<pattern::Placement> drawn;          ///< where the file of patterns has it
};

/// Description of the list "Panels": one entry a panel, with its shape, mesh and placement.
base::Spec panels_spec();

/// Meshes all entries of "Panels"; edges that an entry of "Seams" (null: none) joins get the same nodes where their
/// meshers leave a choice. Throws InputError, with the place in the pattern, for an outline that is open, crosses
/// itself or runs clockwise, for a mesh whose elements fold over, and for shell options that do not go together.
std::vector<Panel> build_panels(const base::List& panels, const base::List* seams);

}  // namespace toile::garment
