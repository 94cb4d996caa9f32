#pragma once

#include <map>
#include <string>
#include <vector>

#include "toile/mesh/panel_mesh.hpp"

namespace toile::mesh {

/// What a zone of a panel is, by its name.
struct ZonePlaces {
  std::map<std::string, Vec2> points;                ///< a point of it, mm: it goes as far as the lines of nodes
  std::map<std::string, std::vector<Vec2>> borders;  ///< corners of a polygon, mm: all elements whose centre is inside
};

/// Divides the parts of a panel into zones: a zone of a point is what can be reached from there without crossing a line
/// of nodes, one of a border is what lies within it. Throws InputError if a point lies in no element, if two lie in one
/// area between lines, and for a zone that has no elements or those of another one.
void divide_into_zones(PanelMesh& panel, const std::vector<std::vector<int>>& lines, const ZonePlaces& zones);

}  // namespace toile::mesh
