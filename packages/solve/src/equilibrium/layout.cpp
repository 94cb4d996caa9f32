#include "equilibrium/layout.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace toile::solve {

namespace {

std::vector<int> clusters_of_nodes(const Problem& problem) {
  std::vector<int> of(problem.mesh->nodes(), -1);
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) of[node] = static_cast<int>(c);
  return of;
}

}  // namespace

Layout::Layout(const Problem& problem, const Held& all, RCP<const Comm> communicator)
    : comm(std::move(communicator)), contact(problem.surface != nullptr) {
  find_local(problem);
  number(problem, all);
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const size_t local = maps.dof->getNodeNumElements() + (contact ? static_cast<size_t>(owned_clusters) : 0);
  maps.state = rcp(new Map(unknown, local, 0, comm));
}

void Layout::find_local(const Problem& problem) {
  const int rank = comm->getRank();
  const std::vector<int> cluster_of = clusters_of_nodes(problem);
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    if (problem.cluster_rank[c] == rank) clusters.push_back(static_cast<int>(c));
  owned_clusters = static_cast<int>(clusters.size());

  std::set<int> ghosts, all_nodes;
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) {
    const mesh::Block& block = problem.mesh->blocks[b];
    BlockPart part{static_cast<int>(b), problem.models[b].is_shell(), {}, {}, {}};
    for (int e = 0; e < block.size(); ++e) {
      const int* node = &block.connectivity[static_cast<size_t>(e) * block.nodes_per_element];
      const bool touches = std::any_of(node, node + block.nodes_per_element,
                                       [&](int n) { return problem.cluster_rank[cluster_of[n]] == rank; });
      const bool owned = problem.element_rank[b][e] == rank;
      if (!touches && !owned) continue;
      part.elements.push_back(e);
      part.owned.push_back(owned ? 1 : 0);
      for (int i = 0; i < block.nodes_per_element; ++i) {
        all_nodes.insert(node[i]);
        if (problem.cluster_rank[cluster_of[node[i]]] != rank) ghosts.insert(cluster_of[node[i]]);
      }
    }
    blocks.push_back(std::move(part));
  }
  clusters.insert(clusters.end(), ghosts.begin(), ghosts.end());
  // Members of owned clusters that no local element touches cannot exist: their elements touch the cluster.
  nodes.assign(all_nodes.begin(), all_nodes.end());

  std::vector<int> local_cluster(problem.clusters.size(), -1), local_node(problem.mesh->nodes(), -1);
  for (size_t c = 0; c < clusters.size(); ++c) local_cluster[clusters[c]] = static_cast<int>(c);
  for (size_t n = 0; n < nodes.size(); ++n) {
    local_node[nodes[n]] = static_cast<int>(n);
    node_cluster.push_back(local_cluster[cluster_of[nodes[n]]]);
  }
  for (BlockPart& part : blocks) {
    const mesh::Block& block = problem.mesh->blocks[part.block];
    for (const int e : part.elements)
      for (int i = 0; i < block.nodes_per_element; ++i)
        part.nodes.push_back(local_node[block.connectivity[static_cast<size_t>(e) * block.nodes_per_element + i]]);
  }
}

// Unknowns are numbered rank by rank, then by cluster, then by node: every rank can work out the number of a ghost.
std::vector<GlobalId> Layout::first_unknowns(const Problem& problem, const Held& all) const {
  const auto unknowns_of = [&](size_t c) {
    GlobalId count = 0;
    for (const HeldComponent& h : all.position[c]) count += h.held ? 0 : 1;
    for (const int node : problem.clusters[c])
      if (!all.rotation.empty()) count += (all.rotation[node][0] ? 0 : 1) + (all.rotation[node][1] ? 0 : 1);
    return count;
  };
  std::vector<GlobalId> next(comm->getSize() + 1, 0);
  for (size_t c = 0; c < problem.clusters.size(); ++c) next[problem.cluster_rank[c] + 1] += unknowns_of(c);
  for (size_t r = 1; r < next.size(); ++r) next[r] += next[r - 1];
  std::vector<GlobalId> first(problem.clusters.size());
  for (size_t c = 0; c < problem.clusters.size(); ++c) {
    first[c] = next[problem.cluster_rank[c]];
    next[problem.cluster_rank[c]] += unknowns_of(c);
  }
  return first;
}

void Layout::number(const Problem& problem, const Held& all) {
  const std::vector<GlobalId> first = first_unknowns(problem, all);
  std::vector<int> local_node(problem.mesh->nodes(), -1);
  for (size_t n = 0; n < nodes.size(); ++n) local_node[nodes[n]] = static_cast<int>(n);
  shells_ = !all.rotation.empty();
  if (shells_) rotation.assign(nodes.size(), {-1, -1});
  for (size_t n = 0; n < nodes.size() && !all.turned_by.empty(); ++n) turned_by.push_back(all.turned_by[nodes[n]]);

  std::vector<GlobalId> columns;
  GlobalId id = 0;
  const auto take = [&] {
    columns.push_back(id++);
    return static_cast<LocalId>(columns.size()) - 1;
  };
  size_t owned = 0;
  for (size_t c = 0; c < clusters.size(); ++c) {
    id = first[clusters[c]];
    held.push_back(all.position[clusters[c]]);
    if (!all.basis.empty()) basis.push_back(all.basis[clusters[c]]);
    std::array<LocalId, 3> ids = {-1, -1, -1};
    for (size_t i = 0; i < 3; ++i)
      if (!held.back()[i].held) ids[i] = take();
    dof.push_back(ids);
    for (const int node : problem.clusters[clusters[c]])
      for (size_t k = 0; k < 2 && !all.rotation.empty(); ++k) {
        if (all.rotation[node][k]) continue;
        if (local_node[node] >= 0)
          rotation[local_node[node]][k] = take();
        else
          ++id;  // of a ghost cluster, and no element of this rank touches it
      }
    if (static_cast<int>(c) == owned_clusters - 1) owned = columns.size();
  }
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const Teuchos::ArrayView<const GlobalId> view(columns);
  maps.dof = rcp(new Map(unknown, view(0, owned), 0, comm));
  maps.overlap = rcp(new Map(unknown, view, 0, comm));
  maps.importer = rcp(new Import(maps.dof, maps.overlap));
}

void Layout::element_unknowns(const BlockPart& part, size_t element, bool with_rotations,
                              std::vector<LocalId>& ids) const {
  const size_t per = part.nodes.size() / part.elements.size();
  ids.clear();
  for (size_t i = 0; i < per; ++i) {
    const int n = part.nodes[element * per + i];
    ids.insert(ids.end(), dof[node_cluster[n]].begin(), dof[node_cluster[n]].end());
    if (part.shell && with_rotations) ids.insert(ids.end(), rotation[n].begin(), rotation[n].end());
  }
}

Vec3 Layout::components(LocalCluster cluster, const Vec3& position) const {
  return is_turned(cluster) ? Vec3(basis[cluster].across * position) : position;
}

Vec3 Layout::position(LocalCluster cluster, const Vec3& components) const {
  return is_turned(cluster) ? Vec3(basis[cluster].along * components) : components;
}

Vec3 Layout::components_of_force(LocalCluster cluster, const Vec3& force) const {
  return is_turned(cluster) ? Vec3(basis[cluster].along.transpose() * force) : force;
}

Vec3 Layout::direction(LocalCluster cluster, Eigen::Index component) const {
  return is_turned(cluster) ? Vec3(basis[cluster].across.row(component)) : Vec3(Vec3::Unit(component));
}

RCP<const Graph> make_graph(const Layout& layout) {
  const size_t rows = layout.maps.dof->getNodeNumElements();
  std::vector<std::set<LocalId>> columns(rows);
  std::vector<LocalId> ids;
  for (const Layout::BlockPart& part : layout.blocks)
    for (size_t e = 0; e < part.elements.size(); ++e) {
      layout.element_unknowns(part, e, true, ids);
      ids.erase(std::remove(ids.begin(), ids.end(), -1), ids.end());
      for (const LocalId row : ids)
        if (static_cast<size_t>(row) < rows) columns[row].insert(ids.begin(), ids.end());
    }
  Teuchos::ArrayRCP<size_t> offsets(rows + 1, 0);
  for (size_t r = 0; r < rows; ++r) offsets[r + 1] = offsets[r] + columns[r].size();
  Teuchos::ArrayRCP<LocalId> indices(offsets[rows]);
  for (size_t r = 0; r < rows; ++r) std::copy(columns[r].begin(), columns[r].end(), indices.begin() + offsets[r]);
  RCP<Graph> graph = rcp(new Graph(layout.maps.dof, layout.maps.overlap, offsets, indices));
  graph->fillComplete(layout.maps.dof, layout.maps.dof);
  return graph;
}

}  // namespace toile::solve
