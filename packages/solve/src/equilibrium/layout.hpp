#pragma once

#include <array>
#include <vector>

#include "equilibrium/held.hpp"
#include "equilibrium/types.hpp"

namespace toile::solve {

/// Distribution of one stage over the ranks: owned and ghost clusters, local elements, numbering of the unknowns.
///
/// A rank evaluates every element that touches a cluster of its own, so rows are complete without an export of matrix
/// entries; an element counts in sums only on the rank that owns it.
/// Local order: owned clusters first, then ghosts. Unknowns are the free components of the clusters' positions and,
/// after those of its cluster, the free rotations of each node of a shell (`maps.dof`, `maps.overlap`); with a body,
/// `maps.state` appends one contact multiplier per owned cluster.
class Layout {
 public:
  struct BlockPart {
    int block;                     ///< in the mesh
    bool shell;                    ///< two rotations a node
    std::vector<int> elements;     ///< ids in the block, ascending
    std::vector<char> owned;       ///< [local element]
    std::vector<LocalNode> nodes;  ///< [local element][node]
  };

  /// Of the unknowns over the ranks.
  struct Maps {
    RCP<const Map> dof, overlap, state;
    RCP<const Import> importer;  ///< dof -> overlap
  };

  Layout(const Problem& problem, const Held& held, RCP<const Comm> comm);

  /// Unknowns of an element in the order of its formulation, -1 where held; rotations left out on wish.
  void element_unknowns(const BlockPart& part, size_t element, bool with_rotations, std::vector<LocalId>& ids) const;
  /// The same on every rank, also on one without a node.
  bool has_shells() const { return shells_; }

  bool is_turned(LocalCluster cluster) const { return !basis.empty() && basis[static_cast<size_t>(cluster)].turned; }
  /// Components of the position of a local cluster, and the position of its components.
  Vec3 components(LocalCluster cluster, const Vec3& position) const;
  Vec3 position(LocalCluster cluster, const Vec3& components) const;
  /// Components of a force on a local cluster, or of a normal: f.dy/dq.
  Vec3 components_of_force(LocalCluster cluster, const Vec3& force) const;
  /// Direction of the force of a support that holds a component.
  Vec3 direction(LocalCluster cluster, Eigen::Index component) const;

  RCP<const Comm> comm;
  std::vector<GlobalCluster> clusters;  ///< [local cluster]
  int owned_clusters = 0;
  std::vector<GlobalNode> nodes;           ///< [local node]
  std::vector<LocalCluster> node_cluster;  ///< [local node]
  std::vector<BlockPart> blocks;
  std::vector<std::array<HeldComponent, 3>> held;  ///< [local cluster]
  std::vector<Basis> basis;                 ///< [local cluster] of these components; empty where all are x, y and z
  std::vector<std::array<LocalId, 3>> dof;  ///< [local cluster] local (overlap) dof or -1
  std::vector<std::array<LocalId, 2>> rotation;  ///< [local node] local dof or -1; empty without shells
  std::vector<int> turned_by;                    ///< [local node] as in Held
  bool contact = false;                          ///< there is a body
  Maps maps;

 private:
  bool shells_ = false;

  void find_local(const Problem& problem);
  std::vector<GlobalId> first_unknowns(const Problem& problem, const Held& all) const;
  void number(const Problem& problem, const Held& all);
};

/// Sparsity of the displacement tangent: every pair of clusters that share an element.
RCP<const Graph> make_graph(const Layout& layout);

}  // namespace toile::solve
