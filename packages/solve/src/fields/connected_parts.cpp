#include "toile/solve/connected_parts.hpp"

#include <map>
#include <utility>

namespace toile::solve {

std::vector<std::vector<int>> connected_parts(const Problem& problem) {
  std::vector<int> cluster_of(problem.mesh->nodes()), parent(problem.clusters.size());
  for (size_t c = 0; c < problem.clusters.size(); ++c) {
    parent[c] = static_cast<int>(c);
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  }
  const auto root = [&parent](int c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  for (const mesh::Block& block : problem.mesh->blocks)
    for (size_t i = 0; i < block.connectivity.size(); ++i) {
      const size_t first = i - i % static_cast<size_t>(block.nodes_per_element);
      parent[root(cluster_of[block.connectivity[i]])] = root(cluster_of[block.connectivity[first]]);
    }
  std::map<int, std::vector<int>> parts;
  for (size_t c = 0; c < parent.size(); ++c) parts[root(static_cast<int>(c))].push_back(static_cast<int>(c));
  std::vector<std::vector<int>> all;
  for (auto& [id, clusters] : parts) all.push_back(std::move(clusters));
  return all;
}

}  // namespace toile::solve
