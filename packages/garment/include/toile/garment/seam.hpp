#pragma once

#include <string>
#include <utility>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::garment {

/// Two edges of panels that are sewn together, node by node.
struct Seam {
  std::string name;
  std::string first;  ///< name of an edge, see mesh::Mesh::edges
  std::string second;
  std::vector<std::pair<int, int>> pairs;  ///< node of the first edge, node of the second, in the order of the first
  std::vector<int> first_nodes = {}, second_nodes = {};  ///< of the edges in the order of sewing, shared corners too
};

/// Description of the list "Seams": one entry a seam.
base::Spec seams_spec();

/// Pairs the nodes of each entry of "Seams" by arc length. Throws InputError if an edge does not exist (with the
/// nearest name), if the edges have different numbers of nodes, if their lengths in the pattern differ by more than
/// `ease`, or if their nodes do not face each other.
std::vector<Seam> build_seams(const base::List& seams, const mesh::Mesh& mesh);

/// Nodes that the seams tie together. Ids are consecutive; a node without a seam is a cluster of its own.
struct Clusters {
  std::vector<int> of_node;               ///< [node] its cluster
  std::vector<std::vector<int>> members;  ///< [cluster] ascending; the first is the master

  int master(int node) const { return members[of_node[node]].front(); }
};

/// Union of all pairs of all seams. Clusters are numbered in the order of their masters.
Clusters build_clusters(int nodes, const std::vector<Seam>& seams);

/// [cluster] Name of the first seam that ties it; empty where none does.
std::vector<std::string> seam_names(const Clusters& clusters, const std::vector<Seam>& seams);

/// Prescribed separation of a node from its cluster's master, x_k = x_m + d_k(lambda) with
/// d_k(lambda) = (1 - lambda) (X_k - X_m) and X the placed positions, mm: open at lambda = 0, tied at 1.
mesh::Vec3 separation(const mesh::Mesh& mesh, const Clusters& clusters, int node, double lambda);

}  // namespace toile::garment
