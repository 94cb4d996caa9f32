#include "toile/mesh/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <string>

#include "toile/base/error.hpp"

namespace toile::mesh {
namespace {

/// Clusters of each element, without repetitions, in the compressed form that METIS reads.
struct ElementClusters {
  std::vector<idx_t> start{0};
  std::vector<idx_t> ids;
  idx_t clusters = 0;
};

ElementClusters element_clusters(const Mesh& mesh, const std::vector<int>& cluster_of_node) {
  ElementClusters result;
  for (const Block& block : mesh.blocks) {
    for (int e = 0; e < block.size(); ++e) {
      const int* nodes = &block.connectivity[e * block.nodes_per_element];
      const auto first = static_cast<std::ptrdiff_t>(result.ids.size());
      for (int k = 0; k < block.nodes_per_element; ++k) {
        const idx_t cluster = cluster_of_node[nodes[k]];
        if (std::find(result.ids.begin() + first, result.ids.end(), cluster) != result.ids.end()) continue;
        result.ids.push_back(cluster);
      }
      result.start.push_back(static_cast<idx_t>(result.ids.size()));
    }
  }
  result.clusters = 1 + *std::max_element(cluster_of_node.begin(), cluster_of_node.end());
  return result;
}

std::vector<int> split_elements(ElementClusters& graph, int ranks) {
  auto elements = static_cast<idx_t>(graph.start.size() - 1);
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_PTYPE] = METIS_PTYPE_RB;  // better balance than k-way for the few parts that we need
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_NUMBERING] = 0;
  idx_t common = 2;  // elements are neighbours if they share an edge
  idx_t parts = ranks;
  idx_t cut = 0;
  std::vector<idx_t> element_part(elements), node_part(graph.clusters);
  const int status =
      METIS_PartMeshDual(&elements, &graph.clusters, graph.start.data(), graph.ids.data(), nullptr, nullptr, &common,
                         &parts, nullptr, options.data(), &cut, element_part.data(), node_part.data());
  if (status != METIS_OK) {
    throw base::Error(base::ExitCode::internal_error, "METIS failed with status " + std::to_string(status));
  }
  return {element_part.begin(), element_part.end()};
}

/// Each cluster goes to the one of its ranks that owns the fewest so far.
std::vector<int> assign_clusters(const ElementClusters& graph, const std::vector<int>& element_rank, int ranks) {
  std::vector<std::vector<int>> touching(graph.clusters);
  for (std::size_t e = 0; e < element_rank.size(); ++e) {
    for (idx_t k = graph.start[e]; k < graph.start[e + 1]; ++k) touching[graph.ids[k]].push_back(element_rank[e]);
  }
  std::vector<int> owned(ranks, 0);
  std::vector<int> owner(graph.clusters, 0);
  for (idx_t c = 0; c < graph.clusters; ++c) {
    assert(!touching[c].empty());
    owner[c] = *std::min_element(touching[c].begin(), touching[c].end(),
                                 [&owned](int a, int b) { return owned[a] != owned[b] ? owned[a] < owned[b] : a < b; });
    ++owned[owner[c]];
  }
  return owner;
}

}  // namespace

Partition partition(const Mesh& mesh, const std::vector<int>& cluster_of_node, int ranks) {
  assert(static_cast<int>(cluster_of_node.size()) == mesh.nodes() && mesh.nodes() > 0);
  const int elements = mesh.elements();
  if (ranks > elements) {
    throw base::InputError("the garment has " + std::to_string(elements) + " elements, too few for " +
                           std::to_string(ranks) + " ranks: start fewer processes or refine the panels");
  }
  ElementClusters graph = element_clusters(mesh, cluster_of_node);
  Partition result;
  result.ranks = ranks;
  result.element_rank = ranks == 1 ? std::vector<int>(elements, 0) : split_elements(graph, ranks);
  result.cluster_rank = assign_clusters(graph, result.element_rank, ranks);
  return result;
}

}  // namespace toile::mesh
