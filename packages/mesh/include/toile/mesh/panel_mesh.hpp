#pragma once

#include <map>
#include <string>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

/// Elements of a panel with the same number of nodes, and of one zone.
struct PanelPart {
  std::string zone;  ///< empty: the panel outside of all zones
  int nodes_per_element = 4;
  std::vector<int> connectivity;  ///< nodes of the panel, counter-clockwise
};

/// Mesh of one panel in its pattern, however it was made.
struct PanelMesh {
  std::vector<Vec2> nodes;  ///< mm
  std::vector<PanelPart> parts;
  std::map<std::string, std::vector<int>> edges;  ///< ordered nodes along each named edge and line
  std::vector<Notch> notches;
  int across = 0;  ///< elements a row, if nodes are numbered row by row; 0: a free mesh

  int rows() const { return static_cast<int>(nodes.size()) / (across + 1); }  ///< of nodes, if there are any
  int node(int i, int j) const { return j * (across + 1) + i; }               ///< i from the left in row j
};

/// [node] Whether it lies on an edge.
std::vector<bool> on_edges(const PanelMesh& panel);

/// Fabric of a zone, or of the panel outside of all zones (empty name).
struct ZoneFabric {
  std::string material;
  double wale_angle = 0.0;  ///< radians from the pattern's x axis
};

/// Adds the panel with its nodes, a block for each part, and its edges "<panel>.<edge>". A block is called like the
/// panel if it is the only one, else "<panel>-<zone>", with "-triangles" where quadrilaterals have that name already.
/// `placed`: one point and one normal a node; `fabrics`: of the zones by name.
void add_panel(Mesh& mesh, const std::string& name, const PanelMesh& panel, const Placed& placed,
               const std::map<std::string, ZoneFabric>& fabrics);

}  // namespace toile::mesh
