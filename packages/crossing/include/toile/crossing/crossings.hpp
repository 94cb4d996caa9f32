#pragma once

#include <string>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::crossing {

/// Fabric that passes through fabric: of two panels, or of one panel through itself.
struct PanelCrossing {
  int first = 0, second = 0;              ///< panels, the smaller index first
  int pairs = 0;                          ///< of elements
  double length = 0.0;                    ///< of the lines along which they cross, mm
  double depth = 0.0;                     ///< how far the fabric is through within two elements of the lines, mm
  mesh::Vec3 place = mesh::Vec3::Zero();  ///< on the line where that is deepest, mm
};

struct Crossings {
  std::vector<PanelCrossing> panels;  ///< by their indices; empty: nothing crosses
  std::vector<double> length;         ///< [element] of the lines in it, mm
};

/// Least depth, and least length of all lines between two panels, in parts of the mean side of the elements that cross.
/// Less is fabric that lies on fabric: the flat elements of two layers on one round surface are through each other too.
constexpr double least_depth = 0.1, least_length = 0.1;

/// Finds where mid-surfaces cross. `clusters`: nodes that seams tie; `position`: [node] mm. Elements that have a node
/// or a cluster in common do not cross. The result depends on nothing but the arguments.
Crossings find_crossings(const mesh::Mesh& mesh, const std::vector<std::vector<int>>& clusters,
                         const std::vector<mesh::Vec3>& position);

/// "sleeve x front (12 pairs of elements, 34 mm long, 3.1 mm deep near (1, 2, 3) mm), ..."
std::string text_of(const Crossings& crossings, const mesh::Mesh& mesh);

/// False in a build without CGAL (TOILE_ENABLE_BODY=OFF): nothing is found then.
bool available();

}  // namespace toile::crossing
