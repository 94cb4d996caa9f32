// What an equilibrium remembers between steps, as plain values that are the same on every rank.
#include <Teuchos_CommHelpers.hpp>
#include <algorithm>

#include "equilibrium.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

namespace {

constexpr size_t per_cluster = 4;  // components of the position, multiplier

std::vector<double> sum_over_ranks(const Comm& comm, const std::vector<double>& mine) {
  std::vector<double> all(mine.size());
  Teuchos::reduceAll(comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  return all;
}

}  // namespace

Unknowns Equilibrium::gather(const Vector& z) const {
  const size_t clusters = problem_.clusters.size(), nodes = start_.frame.size();
  Unknowns mine(per_cluster * clusters + 2 * nodes, 0.0);
  const auto data = z.getData();
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    double* out = &mine[per_cluster * static_cast<size_t>(layout_.clusters[c])];
    for (int i = 0; i < 3; ++i)
      if (layout_.dof[c][i] >= 0) out[i] = data[layout_.dof[c][i]];
  }
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t c = 0; c < multipliers(); ++c)
    mine[per_cluster * static_cast<size_t>(layout_.clusters[c]) + 3] = data[first + c];
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (size_t k = 0; k < 2; ++k)
      if (layout_.rotation[n][k] >= 0)
        mine[per_cluster * clusters + 2 * static_cast<size_t>(layout_.nodes[n]) + k] = data[layout_.rotation[n][k]];
  }
  return sum_over_ranks(*layout_.comm, mine);
}

RCP<Vector> Equilibrium::scatter(const Unknowns& all) const {
  if (all.empty()) return Teuchos::null;
  const size_t clusters = problem_.clusters.size();
  const RCP<Vector> z = rcp(new Vector(layout_.state_map));
  auto data = z->getDataNonConst();
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int i = 0; i < 3; ++i)
      if (layout_.dof[c][i] >= 0)
        data[layout_.dof[c][i]] = all[per_cluster * static_cast<size_t>(layout_.clusters[c]) + static_cast<size_t>(i)];
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t c = 0; c < multipliers(); ++c)
    data[first + c] = all[per_cluster * static_cast<size_t>(layout_.clusters[c]) + 3];
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (size_t k = 0; k < 2; ++k)
      if (layout_.rotation[n][k] >= 0)
        data[layout_.rotation[n][k]] = all[per_cluster * clusters + 2 * static_cast<size_t>(layout_.nodes[n]) + k];
  }
  return z;
}

EquilibriumMemory Equilibrium::memory(const Vector& z) const {
  const size_t clusters = problem_.clusters.size(), nodes = start_.frame.size();
  EquilibriumMemory memory;
  memory.z = gather(z);
  memory.s = s_previous_;
  memory.damping = damping_;
  memory.shift = last_shift_;
  std::vector<double> mine(per_cluster * clusters, 0.0);
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    double* out = &mine[per_cluster * static_cast<size_t>(layout_.clusters[c])];
    std::copy_n(projection_.normal(c).data(), 3, out);
    out[3] = offset_[c];
  }
  const std::vector<double> contact = sum_over_ranks(*layout_.comm, mine);
  for (size_t c = 0; c < clusters; ++c) {
    memory.normal.emplace_back(contact[per_cluster * c], contact[per_cluster * c + 1], contact[per_cluster * c + 2]);
    memory.offset.push_back(contact[per_cluster * c + 3]);
  }
  if (!layout_.has_shells()) return memory;
  constexpr size_t per_node = 11;  // the frame and theta
  mine.assign(per_node * nodes, 0.0);
  for (size_t n = 0; n < frames_.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    double* out = &mine[per_node * static_cast<size_t>(layout_.nodes[n])];
    std::copy_n(frames_[n].data(), 9, out);
    std::copy_n(&rotation_previous_[2 * n], 2, out + 9);
  }
  const std::vector<double> turned = sum_over_ranks(*layout_.comm, mine);
  memory.frame.resize(nodes);
  for (size_t n = 0; n < nodes; ++n) {
    std::copy_n(&turned[per_node * n], 9, memory.frame[n].data());
    memory.rotation.insert(memory.rotation.end(), &turned[per_node * n + 9], &turned[per_node * n + 11]);
  }
  memory.frozen = sum_over_ranks(*layout_.comm, elements_.frozen());
  return memory;
}

// The unknowns tell where the step began.
RCP<Vector> Equilibrium::resume(const EquilibriumMemory& memory) {
  const RCP<Vector> z = scatter(memory.z);
  damping_ = memory.damping;
  last_shift_ = memory.shift;
  std::vector<Vec3> normals;
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    offset_[c] = memory.offset[layout_.clusters[c]];
    normals.push_back(memory.normal[layout_.clusters[c]]);
  }
  projection_.set(normals);
  if (layout_.has_shells()) {
    for (size_t n = 0; n < frames_.size(); ++n) {
      const size_t node = static_cast<size_t>(layout_.nodes[n]);
      frames_[n] = memory.frame[node];
      std::copy_n(&memory.rotation[2 * node], 2, &rotation_previous_[2 * n]);
    }
    elements_.set_frames(frames_);
    elements_.set_frozen(memory.frozen);
  }
  s_previous_ = memory.s;
  positions(*z, memory.s);
  x_previous_ = at_.x;
  want_fresh_ = true;
  return z;
}

}  // namespace toile::solve
