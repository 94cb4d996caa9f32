// An equilibrium's states, and what it remembers between steps, as plain values that are the same on every rank.
#include <algorithm>
#include <utility>

#include "equilibrium/equilibrium.hpp"
#include "equilibrium/unknowns.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

namespace {

/// Of all nodes of the mesh, the same on every rank.
struct Directors {
  std::vector<Frame> frame;   ///< [node]
  std::vector<double> theta;  ///< [node][2]
};

/// `frame` of a local node, `theta` of place 2 node + k. Collective.
template <class FrameOf, class ThetaOf>
Directors gather_directors(const Layout& layout, size_t nodes, const FrameOf& frame, const ThetaOf& theta) {
  constexpr size_t per_node = 11;  // the frame and theta
  std::vector<double> mine(per_node * nodes, 0.0);
  for (size_t n = 0; n < layout.nodes.size(); ++n) {
    if (layout.node_cluster[n] >= layout.owned_clusters) continue;
    double* out = &mine[per_node * static_cast<size_t>(layout.nodes[n])];
    const Frame own = frame(n);
    std::copy_n(own.data(), 9, out);
    for (size_t k = 0; k < 2; ++k) out[9 + k] = theta(2 * n + k);
  }
  const std::vector<double> all = sum_over_ranks(*layout.comm, mine);
  Directors directors;
  directors.frame.resize(nodes);
  for (size_t n = 0; n < nodes; ++n) {
    std::copy_n(&all[per_node * n], 9, directors.frame[n].data());
    directors.theta.insert(directors.theta.end(), &all[per_node * n + 9], &all[per_node * n] + per_node);
  }
  return directors;
}

}  // namespace

RCP<Vector> Equilibrium::start_vector() const {
  return vector_of(layout_, start_);
}

int Equilibrium::global_contact_nodes() const {
  return static_cast<int>(layout_.maps.state->getGlobalNumElements() - layout_.maps.dof->getGlobalNumElements());
}

Unknowns Equilibrium::gather(const Vector& z) const {
  return solve::gather(layout_, problem_, z);
}

RCP<Vector> Equilibrium::scatter(const Unknowns& values) const {
  return solve::scatter(layout_, problem_, values);
}

State Equilibrium::state(const Vector& z, double s) const {
  const Configuration at = kinematics_.at(z, s);
  State state;
  const size_t clusters = problem_.clusters.size();
  const size_t kept = contact_ ? static_cast<size_t>(problem_.contact.law->history_values()) : 0;
  std::vector<double> mine((5 + kept) * clusters, 0.0);
  const std::vector<double> pressing = contact_ ? contact_->pressing_forces(at) : std::vector<double>();
  const std::vector<double> history = contact_ ? contact_->history_after(at) : std::vector<double>();
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    const size_t global = static_cast<size_t>(layout_.clusters[c]), own = static_cast<size_t>(c);
    std::copy_n(&at.master[3 * own], 3, &mine[3 * global]);
    mine[4 * clusters + global] = contact_ ? contact_->offsets()[own] : start_.offset[global];
    if (!contact_) continue;
    mine[3 * clusters + global] = pressing[own];
    std::copy_n(history.data() + kept * own, kept, mine.data() + 5 * clusters + kept * global);
  }
  const std::vector<double> all = sum_over_ranks(*layout_.comm, mine);
  const auto part = [&](size_t from, size_t to) {
    return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(from * clusters),
                               all.begin() + static_cast<std::ptrdiff_t>(to * clusters));
  };
  for (size_t c = 0; c < clusters; ++c) state.position.emplace_back(all[3 * c], all[3 * c + 1], all[3 * c + 2]);
  state.contact_force = part(3, 4);
  state.offset = part(4, 5);
  state.contact_history = part(5, 5 + kept);
  state.seam = kinematics_.drive().seam(s);
  state.load = kinematics_.drive().load(s);
  if (!layout_.has_shells()) return state;
  Directors directors = gather_directors(
      layout_, start_.frame.size(), [&](size_t n) { return kinematics_.frame(n, at); },
      [&](size_t n) { return kinematics_.theta()[n] + at.rotation[n]; });
  state.frame = std::move(directors.frame);
  for (size_t n = 0; n < state.frame.size(); ++n)
    state.rotation.push_back({directors.theta[2 * n], directors.theta[2 * n + 1]});
  return state;
}

EquilibriumMemory Equilibrium::memory(const Vector& z) const {
  EquilibriumMemory memory;
  memory.z = gather(z);
  memory.s = kinematics_.step_start();
  memory.damping = damping();
  memory.shift = tangent_->last_shift();
  if (contact_) add_contact(memory);
  if (!layout_.has_shells()) return memory;
  Directors directors = gather_directors(
      layout_, start_.frame.size(), [&](size_t n) { return kinematics_.frames()[n]; },
      [&](size_t n) { return kinematics_.theta()[n]; });
  memory.frame = std::move(directors.frame);
  memory.rotation = std::move(directors.theta);
  memory.frozen = sum_over_ranks(*layout_.comm, strain_.frozen());
  return memory;
}

void Equilibrium::add_contact(EquilibriumMemory& memory) const {
  const size_t clusters = problem_.clusters.size();
  const size_t kept = static_cast<size_t>(problem_.contact.law->history_values()), per_cluster = 4 + kept;
  std::vector<double> mine(per_cluster * clusters, 0.0);
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    double* out = &mine[per_cluster * static_cast<size_t>(layout_.clusters[c])];
    std::copy_n(contact_->projection().normal(c).data(), 3, out);
    out[3] = contact_->offsets()[static_cast<size_t>(c)];
    std::copy_n(contact_->history().data() + kept * static_cast<size_t>(c), kept, out + 4);
  }
  const std::vector<double> all = sum_over_ranks(*layout_.comm, mine);
  for (size_t c = 0; c < clusters; ++c) {
    const double* at = &all[per_cluster * c];
    memory.normal.emplace_back(at[0], at[1], at[2]);
    memory.offset.push_back(at[3]);
    memory.contact_history.insert(memory.contact_history.end(), at + 4, at + per_cluster);
  }
}

// The unknowns tell where the step began.
RCP<Vector> Equilibrium::resume(const EquilibriumMemory& memory) {
  const RCP<Vector> z = scatter(memory.z);
  set_damping(memory.damping);
  tangent_->set_last_shift(memory.shift);
  if (contact_) contact_->resume(memory.normal, memory.offset, memory.contact_history);
  kinematics_.resume(memory.s, memory.frame, memory.rotation);
  if (layout_.has_shells()) {
    strain_.set_frames(kinematics_.frames());
    strain_.set_frozen(memory.frozen);
  }
  const Configuration at = kinematics_.at(*z, memory.s);
  for (Term* term : terms_) term->start_step(at);
  tangent_->renew();
  return z;
}

}  // namespace toile::solve
