#pragma once

#include <map>
#include <string>

#include "cut.hpp"
#include "toile/base/parameters.hpp"
#include "toile/mesh/panel_mesh.hpp"

namespace toile::garment {

/// Description of the list "Zones" of a panel.
base::Spec zones_spec();

/// Adds to a panel's internal lines the borders of its zones, which sides of elements then follow. Throws InputError
/// for a zone that has not exactly one of point, band and border, and for borders that cannot be.
void add_borders(const base::List& panel, Cut& cut);

/// Fabric by zone; empty: outside of all zones.
std::map<std::string, mesh::ZoneFabric> read_fabrics(const base::List& panel);

/// Divides the mesh of a panel. Throws InputError.
void divide_into_zones(const base::List& panel, const Cut& cut, mesh::PanelMesh& mesh);

}  // namespace toile::garment
