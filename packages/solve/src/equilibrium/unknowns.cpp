#include "equilibrium/unknowns.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace toile::solve {

namespace {

constexpr size_t per_cluster = 4;  // components of the position, multiplier

/// Calls use(unknown of this rank, its place among all values) for each unknown of owned clusters.
template <class Use>
void for_each_unknown(const Layout& layout, const Problem& problem, const Use& use) {
  const size_t first = layout.maps.dof->getNodeNumElements(), rotations = per_cluster * problem.clusters.size();
  for (int c = 0; c < layout.owned_clusters; ++c) {
    const size_t place = per_cluster * static_cast<size_t>(layout.clusters[c]);
    for (size_t i = 0; i < 3; ++i)
      if (layout.dof[c][i] >= 0) use(static_cast<size_t>(layout.dof[c][i]), place + i);
    if (layout.contact) use(first + static_cast<size_t>(c), place + 3);
  }
  for (size_t n = 0; n < layout.rotation.size(); ++n) {
    if (layout.node_cluster[n] >= layout.owned_clusters) continue;
    for (size_t k = 0; k < 2; ++k)
      if (layout.rotation[n][k] >= 0)
        use(static_cast<size_t>(layout.rotation[n][k]), rotations + 2 * static_cast<size_t>(layout.nodes[n]) + k);
  }
}

}  // namespace

RCP<Vector> vector_of(const Layout& layout, const State& state) {
  const RCP<Vector> z = rcp(new Vector(layout.maps.state));
  auto data = z->getDataNonConst();
  const size_t first = layout.maps.dof->getNodeNumElements();
  for (int c = 0; c < layout.owned_clusters; ++c) {
    const Vec3 components = layout.components(c, state.position[layout.clusters[c]]);
    for (int i = 0; i < 3; ++i)
      if (layout.dof[c][i] >= 0) data[layout.dof[c][i]] = components[i];
    if (layout.contact) data[first + static_cast<size_t>(c)] = state.contact_force[layout.clusters[c]];
  }
  for (size_t n = 0; n < layout.rotation.size(); ++n) {
    if (layout.node_cluster[n] >= layout.owned_clusters) continue;
    for (size_t k = 0; k < 2; ++k)
      if (layout.rotation[n][k] >= 0) data[layout.rotation[n][k]] = state.rotation[layout.nodes[n]][k];
  }
  return z;
}

Unknowns gather(const Layout& layout, const Problem& problem, const Vector& z) {
  const size_t rotations = layout.has_shells() ? 2 * static_cast<size_t>(problem.mesh->nodes()) : 0;
  Unknowns mine(per_cluster * problem.clusters.size() + rotations, 0.0);
  const auto data = z.getData();
  for_each_unknown(layout, problem,
                   [&](size_t own, size_t place) { mine[place] = data[static_cast<std::ptrdiff_t>(own)]; });
  return sum_over_ranks(*layout.comm, mine);
}

RCP<Vector> scatter(const Layout& layout, const Problem& problem, const Unknowns& all) {
  if (all.empty()) return Teuchos::null;
  const RCP<Vector> z = rcp(new Vector(layout.maps.state));
  auto data = z->getDataNonConst();
  for_each_unknown(layout, problem,
                   [&](size_t own, size_t place) { data[static_cast<std::ptrdiff_t>(own)] = all[place]; });
  return z;
}

std::vector<double> sum_over_ranks(const Comm& comm, const std::vector<double>& mine) {
  std::vector<double> all(mine.size());
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  return all;
}

}  // namespace toile::solve
