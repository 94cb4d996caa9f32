#pragma once

#include <optional>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/body/body.hpp"
#include "toile/mesh/panel_mesh.hpp"
#include "toile/pattern/panel.hpp"

namespace toile::garment {

/// What a placement works on.
struct FlatPanel {
  const mesh::PanelMesh& mesh;
  const std::optional<pattern::Placement>& drawn;  ///< where the file of patterns has the panel
  const body::Surface* body = nullptr;             ///< null: the scene has none
};

/// One way of placing a panel in space: its parameters, and the positions and normals that it gives to the nodes of a
/// mesh. Normals are those of the surface that the panel is placed on, exact for all but imported bodies.
/// Throws InputError through `placement.fail`.
struct Placement {
  base::Spec spec;
  mesh::Placed (*place)(const base::List& placement, const FlatPanel& panel);
  /// Part of the body round which the panel lies, if it is between two heights of a straight axis; null if the
  /// placement never tells.
  std::optional<body::Region> (*reach)(const base::List& placement);
};

/// All placements; a new one is a source of its own and a line here.
const std::vector<Placement>& placements();

Placement wrap_placement();       ///< round the body
Placement free_wrap_placement();  ///< round a cylinder or cone, without a body
Placement sphere_placement();     ///< onto a sphere
Placement guide_placement();      ///< onto any body along a line on it
Placement pattern_placement();    ///< where the file of patterns has it

/// The parameters of pattern_placement(), as a list of this name.
base::Spec pattern_placement_spec(const std::string& name, const std::string& text);

/// Description of the list "Placement" of a panel.
base::Spec placement_spec();

/// The placement that the list "Placement" of a panel names.
const Placement& placement_of(const base::List& list);

/// Start in space of the nodes of a panel, mm. Without a list "Placement" the panel lies in the x-y plane of space.
mesh::Placed place_panel(const base::List& list, const FlatPanel& panel);

}  // namespace toile::garment
