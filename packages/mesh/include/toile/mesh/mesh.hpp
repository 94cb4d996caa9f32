#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace toile::mesh {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// Elements of one panel and fabric with the same number of nodes.
struct Block {
  std::string name;               ///< unique in the mesh: the panel's, or its and what tells the block from the others
  int panel = 0;                  ///< index into Mesh::panels
  std::string material;           ///< name of the "Material" entry
  int nodes_per_element = 4;      ///< 4: quadrilateral, 3: triangle; counter-clockwise in the pattern
  std::vector<int> connectivity;  ///< node ids, nodes_per_element each
  /// Angle (radians) from the pattern's x axis to the wale direction, one an element.
  std::vector<double> wale_angle;
  /// Relative position 0..1 along the panel of each element's centroid (for graduated fabrics).
  std::vector<double> position;

  int size() const { return static_cast<int>(connectivity.size()) / nodes_per_element; }
};

/// A mark on an edge, by which parts of edges are named.
struct Notch {
  std::string name;  ///< unique in its panel
  std::string edge;  ///< without the panel's name
  int node = 0;
};

/// Nodes of one panel, which are consecutive.
struct MeshedPanel {
  std::string name;  ///< unique in the mesh
  int first = 0;     ///< its first node
  int nodes = 0;
  int across = 0;  ///< elements a row, if they lie in rows; 0: a free mesh
  std::vector<Notch> notches;
};

/// Start in space of the nodes of one panel.
struct Placed {
  std::vector<Vec3> position;   ///< mm
  std::vector<Vec3> normal;     ///< unit, along x_,1 x x_,2 with the pattern's axes 1, 2: the right side of the fabric
  std::vector<Vec3> axis = {};  ///< unit direction of the axis that the panel is wrapped round; empty: round none
};

/// The whole garment, the same on every rank. Every panel has nodes of its own: seams tie them (see garment::Seam).
struct Mesh {
  std::vector<Vec2> pattern;  ///< [node] stress-free coordinates in the panel's own plane, mm
  std::vector<Vec3> placed;   ///< [node] start in space, mm
  std::vector<Vec3> normal;   ///< [node] unit normal there (see Placed), a shell's first director; not shared by panels
  std::vector<Vec3> axis;     ///< [node] unit direction of the axis that its panel is wrapped round; zero: round none
  std::vector<MeshedPanel> panels;
  std::vector<Block> blocks;  ///< those of one panel follow each other
  /// Ordered nodes along each named edge of each panel: "front.left", "front.top", ...
  std::map<std::string, std::vector<int>> edges;

  int nodes() const { return static_cast<int>(pattern.size()); }
  int elements() const;
  /// The panel of a block.
  const MeshedPanel& panel_of(const Block& block) const { return panels[static_cast<std::size_t>(block.panel)]; }
  int panel_index(int node) const;  ///< of the panel that a node belongs to
  const MeshedPanel& panel_of_node(int node) const { return panels[static_cast<std::size_t>(panel_index(node))]; }
};

/// Area of an element of a block in the pattern, mm^2.
double pattern_area(const Mesh& mesh, const Block& block, std::size_t element);

/// Length in the pattern from the first of some nodes along the line through them to each one, mm.
std::vector<double> arc_lengths(const Mesh& mesh, const std::vector<int>& nodes);

}  // namespace toile::mesh
