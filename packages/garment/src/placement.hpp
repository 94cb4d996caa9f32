#pragma once

#include <optional>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/body/body.hpp"
#include "toile/mesh/panel_mesh.hpp"

namespace toile::garment {

/// One way of placing a panel in space: its parameters, and the positions and normals that it gives to the nodes of a
/// grid. Normals are those of the surface that the panel is placed on, exact for all but imported bodies.
/// Throws InputError through `placement.fail`. `body` is null if the scene has none.
struct Placement {
  base::Spec spec;
  mesh::Placed (*place)(const base::List& placement, const mesh::PanelMesh& flat, const body::Surface* body);
  /// Part of the body round which the panel lies, if it is between two heights of a straight axis; null if the
  /// placement never tells.
  std::optional<body::Region> (*reach)(const base::List& placement);
};

/// All placements; a new one is a source of its own and a line here.
const std::vector<Placement>& placements();

Placement wrap_placement();       ///< round the body
Placement free_wrap_placement();  ///< round a cylinder or cone, without a body
Placement sphere_placement();     ///< onto a sphere

/// Description of the list "Placement" of a panel.
base::Spec placement_spec();

/// The placement that the list "Placement" of a panel names.
const Placement& placement_of(const base::List& list);

/// Start in space of the nodes of a panel, mm. Without a list "Placement" the panel lies in the x-y plane of space.
mesh::Placed place_panel(const base::List& panel, const mesh::PanelMesh& flat, const body::Surface* body);

}  // namespace toile::garment
