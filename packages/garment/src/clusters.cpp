#include <boost/pending/disjoint_sets.hpp>
#include <numeric>

#include "toile/garment/seam.hpp"

namespace toile::garment {

Clusters build_clusters(int nodes, const std::vector<Seam>& seams) {
  const auto size = static_cast<std::size_t>(nodes);
  std::vector<int> rank(size, 0), parent(size);
  std::iota(parent.begin(), parent.end(), 0);
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  for (const Seam& seam : seams) {
    for (const auto& [a, b] : seam.pairs) sets.union_set(a, b);
  }
  Clusters clusters;
  clusters.of_node.assign(size, -1);
  std::vector<int> of_set(size, -1);
  for (int node = 0; node < nodes; ++node) {
    int& cluster = of_set[static_cast<std::size_t>(sets.find_set(node))];
    if (cluster < 0) {
      cluster = static_cast<int>(clusters.members.size());
      clusters.members.emplace_back();
    }
    clusters.of_node[node] = cluster;
    clusters.members[cluster].push_back(node);
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
