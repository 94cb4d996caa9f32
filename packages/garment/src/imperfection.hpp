#pragma once

#include "toile/base/parameters.hpp"
#include "toile/mesh/panel_mesh.hpp"

namespace toile::garment {

/// Description of the list "Imperfection" of a panel.
base::Spec imperfection_spec();

/// Moves the inner nodes of the placed panel along their normals as its list "Imperfection" says; nothing without it.
/// The nodes on the edges stay, and the normals remain those of the perfect shape. Throws InputError.
void add_imperfection(const base::List& panel, const mesh::PanelMesh& flat, mesh::Placed& placed);

}  // namespace toile::garment
