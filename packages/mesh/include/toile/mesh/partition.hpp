#pragma once

#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

/// Who computes which element and owns which seam cluster; the same on every rank.
struct Partition {
  int ranks = 1;
  std::vector<int> element_rank;  ///< [element] blocks one after another, in the order of Mesh::blocks
  std::vector<int> cluster_rank;  ///< [cluster] one of the ranks that have an element at the cluster
};

/// Splits the elements by METIS (recursive bisection of the dual graph, fixed seed). Nodes of one seam cluster are one
/// vertex of the mesh that METIS sees, so elements on both sides of a seam are neighbours and a slave lives with its
/// master. METIS is not called for one rank. Each rank calls it with the same arguments and gets the same answer.
/// `cluster_of_node`: [node] consecutive ids from 0 (see garment::Clusters); without seams the node's own number.
/// Throws InputError if there are more ranks than elements.
Partition partition(const Mesh& mesh, const std::vector<int>& cluster_of_node, int ranks);

}  // namespace toile::mesh
