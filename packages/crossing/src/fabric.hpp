#pragma once

#include <array>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::crossing {

using mesh::Vec3;
using Triangle = std::array<Vec3, 3>;

/// The elements of all blocks one after another, as they lie in space.
class Fabric {
 public:
  /// Keeps a reference to `position`.
  Fabric(const mesh::Mesh& mesh, const std::vector<std::vector<int>>& clusters, const std::vector<Vec3>& position);

  int elements() const { return static_cast<int>(panel_.size()); }
  int panel(int element) const { return panel_[element]; }
  /// Three or four.
  const std::vector<int>& nodes(int element) const { return nodes_[element]; }
  const Vec3& at(int node) const { return position_[node]; }
  /// One, or two of a quadrilateral, along its first diagonal; none that has no area.
  std::vector<Triangle> triangles(int element) const;
  /// Mean length of its sides, mm.
  double size(int element) const;
  /// The element and those of its panel that have a node in common with it, in ascending order.
  std::vector<int> ring(int element) const;
  /// Elements that have the node.
  const std::vector<int>& around(int node) const { return around_[node]; }
  bool has_cluster_of(int element, int node) const;
  /// Whether two elements have a node in common, or nodes that a seam ties.
  bool joined(int a, int b) const;

 private:
  const std::vector<Vec3>& position_;
  std::vector<std::vector<int>> nodes_;
  std::vector<int> panel_;
  std::vector<int> cluster_;              ///< [node]
  std::vector<std::vector<int>> around_;  ///< [node]
};

}  // namespace toile::crossing
