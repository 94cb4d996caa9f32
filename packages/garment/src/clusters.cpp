#include <algorithm>
#include <numeric>

#include "toile/garment/seam.hpp"

namespace toile::garment {
namespace {

/// Union-find in which the lowest node of a set is its root.
class DisjointNodes {
 public:
  explicit DisjointNodes(int nodes) : parent_(nodes) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  void join(int a, int b) {
    const int low = std::min(root(a), root(b));
    const int high = std::max(root(a), root(b));
    parent_[high] = low;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

Clusters build_clusters(int nodes, const std::vector<Seam>& seams) {
  DisjointNodes sets(nodes);
  for (const Seam& seam : seams) {
    for (const auto& [a, b] : seam.pairs) sets.join(a, b);
  }
  Clusters clusters;
  clusters.of_node.assign(nodes, -1);
  for (int node = 0; node < nodes; ++node) {
    const int root = sets.root(node);
    if (root == node) {
      clusters.of_node[node] = static_cast<int>(clusters.members.size());
      clusters.members.emplace_back();
    }
    clusters.of_node[node] = clusters.of_node[root];
    clusters.members[clusters.of_node[node]].push_back(node);
  }
  return clusters;
}

std::vector<std::string> seam_names(const Clusters& clusters, const std::vector<Seam>& seams) {
  std::vector<std::string> names(clusters.members.size());
  for (const Seam& seam : seams)
    for (const auto& [first, second] : seam.pairs)
      if (std::string& name = names[clusters.of_node[first]]; name.empty()) name = seam.name;
  return names;
}

mesh::Vec3 separation(const mesh::Mesh& mesh, const Clusters& clusters, int node, double lambda) {
  return (1.0 - lambda) * (mesh.placed[node] - mesh.placed[clusters.master(node)]);
}

}  // namespace toile::garment
