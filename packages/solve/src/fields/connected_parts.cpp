#include "toile/solve/connected_parts.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <numeric>
#include <utility>

#include "diagnosis/place.hpp"

namespace toile::solve {

std::vector<std::vector<int>> connected_parts(const Problem& problem) {
  std::vector<int> cluster_of(problem.mesh->nodes()), rank(problem.clusters.size(), 0), parent(problem.clusters.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  for (const mesh::Block& block : problem.mesh->blocks)
    for (size_t i = 0; i < block.connectivity.size(); ++i) {
      const size_t first = i - i % static_cast<size_t>(block.nodes_per_element);
      sets.union_set(cluster_of[block.connectivity[i]], cluster_of[block.connectivity[first]]);
    }
  std::map<int, std::vector<int>> parts;
  for (size_t c = 0; c < parent.size(); ++c) parts[sets.find_set(static_cast<int>(c))].push_back(static_cast<int>(c));
  std::vector<std::vector<int>> all;
  for (auto& [id, clusters] : parts) all.push_back(std::move(clusters));
  std::sort(all.begin(), all.end());
  return all;
}

std::string panels_of(const Problem& problem, const std::vector<int>& clusters) {
  std::vector<std::string> names;
  for (const int c : clusters)
    for (const int node : problem.clusters[c]) {
      const std::string name = panel_of(problem, node);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  std::string text = names.size() > 1 ? "the part of panels " : "panel ";
  for (const std::string& name : names) text += (&name == names.data() ? "\"" : ", \"") + name + "\"";
  return text;
}

}  // namespace toile::solve
