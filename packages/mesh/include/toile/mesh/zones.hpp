#pragma once

#include <map>
#include <string>
#include <vector>

#include "toile/mesh/panel_mesh.hpp"

namespace toile::mesh {

/// Divides the parts of a panel into zones: a zone is what can be reached from a point of it without crossing a line of
/// nodes. `points`: one of each zone, by its name, mm. Throws InputError if a point lies in no element, or if two lie
/// in one zone.
void divide_into_zones(PanelMesh& panel, const std::vector<std::vector<int>>& lines,
                       const std::map<std::string, Vec2>& points);

}  // namespace toile::mesh
