// What is asked of an equilibrium between steps: states, forces, damping and offsets.
#include <Eigen/Geometry>
#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "equilibrium.hpp"

namespace toile::solve {

RCP<Vector> Equilibrium::vector_of(const State& state) const {
  const RCP<Vector> z = rcp(new Vector(layout_.state_map));
  auto data = z->getDataNonConst();
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    const Vec3 components = layout_.components(c, state.position[layout_.clusters[c]]);
    for (int i = 0; i < 3; ++i)
      if (layout_.dof[c][i] >= 0) data[layout_.dof[c][i]] = components[i];
  }
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (size_t k = 0; k < 2; ++k)
      if (layout_.rotation[n][k] >= 0) data[layout_.rotation[n][k]] = state.rotation[layout_.nodes[n]][k];
  }
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t c = 0; c < multipliers(); ++c) data[first + c] = state.contact_force[layout_.clusters[c]];
  return z;
}

int Equilibrium::global_contact_nodes() const {
  return static_cast<int>(layout_.state_map->getGlobalNumElements() - layout_.dof_map->getGlobalNumElements());
}

Imbalance Equilibrium::imbalance(const Vector& f) const {
  double mine[3] = {0.0, 0.0, 0.0};  // squares of the residual and of its scale; number of gaps that are not a number
  const auto data = f.getData();
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    const Eigen::Map<const Vec3> magnitude(&magnitude_[3 * static_cast<size_t>(c)]);
    for (int d = 0; d < 3; ++d) {
      if (layout_.dof[c][d] < 0) continue;
      const double scale = layout_.is_turned(c) ? layout_.direction(c, d).cwiseProduct(magnitude).norm() : magnitude[d];
      mine[0] += data[layout_.dof[c][d]] * data[layout_.dof[c][d]];
      mine[1] += scale * scale;
    }
  }
  // A moment counts as the pair of forces that it is over the distance of two nodes.
  const double lever_squared = mean_mass_;
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (size_t k = 0; k < 2; ++k) {
      if (layout_.rotation[n][k] < 0) continue;
      const double moment = data[layout_.rotation[n][k]], scale = moment_magnitude_[2 * n + k];
      mine[0] += moment * moment / lever_squared;
      mine[1] += scale * scale / lever_squared;
    }
  }
  double gap = 0.0;
  for (size_t i = layout_.dof_map->getNodeNumElements(); i < static_cast<size_t>(data.size()); ++i) {
    if (std::isnan(data[i])) mine[2] += 1.0;  // a maximum over ranks would lose it
    gap = std::max(gap, std::abs(data[i]));
  }
  Imbalance all;
  double sums[3], largest = 0.0;
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, 3, mine, sums);
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, gap, Teuchos::outArg(largest));
  all.force = std::sqrt(sums[0]);
  // A garment at rest has only the forces of rounded positions: those of 1e-12 mm at every node (with the default
  // tolerance) are no imbalance.
  constexpr double resting = 1e-2;  // mm
  all.force_scale = std::max(std::sqrt(sums[1]), resting * diagonal_norm_);
  all.gap = sums[2] > 0.0 ? std::numeric_limits<double>::quiet_NaN() : largest;
  return all;
}

void Equilibrium::start_step(const Vector& converged, double s) {
  positions(converged, s);
  x_previous_ = at_.x;
  s_previous_ = s;
  want_fresh_ = true;
  if (!layout_.has_shells()) return;
  for (size_t n = 0; n < frames_.size(); ++n) {
    frames_[n] = rotated(frames_[n], at_.rotation[2 * n], at_.rotation[2 * n + 1]);
    for (size_t k = 0; k < 2; ++k) rotation_previous_[2 * n + k] += at_.rotation[2 * n + k];
  }
  std::fill(at_.rotation.begin(), at_.rotation.end(), 0.0);
  elements_.set_frames(frames_);
  elements_.find_frozen(at_);
  elements_.adopt_frozen();
}

void Equilibrium::residual_rate(const Vector& z, double s, Vector& rate) {
  constexpr double h = 1e-5;
  const double before = s >= h ? s - h : s;
  Vector start(z.getMap());
  residual(z, before, start);
  residual(z, s + h, rate);
  rate.update(-1.0 / (s + h - before), start, 1.0 / (s + h - before));
}

double Equilibrium::path_direction(const Vector& z, double s, const Vector& dz, double ds) {
  Vector rate(z.getMap()), tangent(z.getMap());
  residual_rate(z, s, rate);
  linearise(z, s);
  if (!solve(rate, tangent)) return ds;
  return ds - dz.dot(tangent) < 0.0 ? -1.0 : 1.0;
}

double Equilibrium::stabilisation_energy(const Vector& z, double s) {
  positions(z, s);
  return sum(elements_.stabilisation_energy(at_));
}

double Equilibrium::dissipation(const Vector& z, double s) {
  positions(z, s);
  double total = 0.0;
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (int d = 0; d < 3; ++d) {
      const double step = at_.x[3 * n + d] - x_previous_[3 * n + d];
      total += mass_[n] * step * step;
    }
  }
  return damping_ / interval(s) * sum(total);
}

// [owned cluster] Half the present thickness.
std::vector<double> Equilibrium::wanted_offsets() {
  const std::vector<double> thickness = elements_.nodal_thickness(at_);
  std::vector<double> sum_of(layout_.clusters.size(), 0.0), count(layout_.clusters.size(), 0.0);
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    sum_of[layout_.node_cluster[n]] += thickness[n];
    count[layout_.node_cluster[n]] += 1.0;
  }
  std::vector<double> wanted;
  for (size_t i = 0; i < offset_.size(); ++i) wanted.push_back(0.5 * sum_of[i] / count[i]);
  return wanted;
}

double Equilibrium::update_thickness(const Vector& z, double s, double tolerance) {
  const bool offsets = layout_.contact && problem_.contact.offset_by_half_thickness;
  if (!offsets && !layout_.has_shells()) return 0.0;
  positions(z, s);
  std::vector<double> wanted = offsets ? wanted_offsets() : offset_;
  double mine = layout_.has_shells() ? elements_.find_frozen(at_) : 0.0, largest = 0.0;
  for (size_t i = 0; i < offset_.size(); ++i) mine = std::max(mine, std::abs(wanted[i] - offset_[i]));
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(largest));
  if (largest <= tolerance) return 0.0;
  offset_ = std::move(wanted);
  if (layout_.has_shells()) elements_.adopt_frozen();
  want_fresh_ = true;
  return largest;
}

// A node presses the body only with a force that would move it further than a gap that is none, or that counts among
// the forces of the garment: less is what rounded positions leave, and would pull unstressed fabric onto the body.
double Equilibrium::least_pressing_force(const ElementAssembly::Sums& sums) const {
  double mine = 0.0, largest = 0.0;
  for (size_t i = 0; i < 3 * static_cast<size_t>(layout_.owned_clusters); ++i)
    mine = std::max(mine, std::abs(sums.magnitude[i]));
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(largest));
  return std::max(options_.newton.gap_tolerance * std::abs(mean_diagonal_), options_.newton.tolerance * largest);
}

void Equilibrium::balance_multipliers(Vector& z, double s) {
  positions(z, s);
  const ElementAssembly::Sums sums = elements_.evaluate(at_, drive_.load(s), nullptr);
  constexpr double touching = 2.0;  // mm: placed nodes this near are taken to lie on the body
  const double least = least_pressing_force(sums);
  auto data = z.getDataNonConst();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < multipliers(); ++i) {
    const Vec3 internal(sums.force[3 * i], sums.force[3 * i + 1], sums.force[3 * i + 2]);
    data[first + i] = contact::balancing_multiplier(contact(static_cast<int>(i), s, 0.0), internal, touching);
    if (data[first + i] <= least) data[first + i] = 0.0;
    if (data[first + i] > 0.0) retract_cluster(i, s, data.getRawPtr());
  }
}

State Equilibrium::state(const Vector& z, double s) {
  positions(z, s);
  State state;
  const size_t clusters = problem_.clusters.size();
  std::vector<double> mine(5 * clusters, 0.0), all(mine.size());
  const auto data = z.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    const size_t global = static_cast<size_t>(layout_.clusters[c]);
    std::copy_n(&y_[3 * static_cast<size_t>(c)], 3, &mine[3 * global]);
    if (layout_.contact) {  // what the iteration leaves on a node that hovers is round-off, not a force
      const double multiplier = data[first + static_cast<size_t>(c)];
      mine[3 * clusters + global] = contact(c, s, multiplier).active ? multiplier : 0.0;
    }
    mine[4 * clusters + global] = offset_[c];
  }
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  for (size_t c = 0; c < clusters; ++c) state.position.emplace_back(all[3 * c], all[3 * c + 1], all[3 * c + 2]);
  state.contact_force.assign(all.begin() + 3 * clusters, all.begin() + 4 * clusters);
  state.offset.assign(all.begin() + 4 * clusters, all.end());
  state.seam = drive_.seam(s);
  state.load = drive_.load(s);
  if (layout_.has_shells()) add_directors(state);
  return state;
}

void Equilibrium::add_directors(State& state) const {
  constexpr size_t per_node = 11;  // the frame and theta
  const size_t nodes = start_.frame.size();
  std::vector<double> mine(per_node * nodes, 0.0), all(mine.size());
  for (size_t n = 0; n < frames_.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    double* out = &mine[per_node * static_cast<size_t>(layout_.nodes[n])];
    const double* w = &at_.rotation[2 * n];
    const Frame frame = rotated(frames_[n], w[0], w[1]);
    std::copy_n(frame.data(), 9, out);
    for (size_t k = 0; k < 2; ++k) out[9 + k] = rotation_previous_[2 * n + k] + w[k];
  }
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  state.frame.resize(nodes);
  state.rotation.resize(nodes);
  for (size_t n = 0; n < nodes; ++n) {
    std::copy_n(&all[per_node * n], 9, state.frame[n].data());
    state.rotation[n] = {all[per_node * n + 9], all[per_node * n + 10]};
  }
}

// Sum of the magnitudes of dead moments and of those that held rotations carry, N mm, of this rank.
double Equilibrium::moment_magnitudes(const ElementAssembly::Sums& sums, double s) const {
  double total = 0.0;
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    total += std::abs(drive_.load(s)) * moment_[n].lpNorm<1>();
    for (int k = 0; k < 2; ++k)
      if (layout_.rotation[n][k] < 0)
        total += std::abs(sums.moment[2 * n + k] - drive_.load(s) * moment_[n].dot(moment_axis(n, k)));
  }
  return total;
}

// Moment about the axis of the clamp that holds a director and turns: what is left of the moments along w, times
// dw/dangle.
double Equilibrium::torque_of_director(const ElementAssembly::Sums& sums, size_t node, double s) const {
  constexpr double h = 1e-5;  // rad
  const Turn& turn = *problem_.supports[layout_.turned_by[node]].turn;
  const double* w = &at_.rotation[2 * node];
  const Vec3 now = rotated(frames_[node], w[0], w[1]).row(2);
  const auto rotation = [&](double angle) {
    return rotation_to(frames_[node], Eigen::AngleAxisd(angle, turn.axis) * now);
  };
  const std::array<double, 2> before = rotation(-h), after = rotation(h);
  double torque = 0.0;
  for (size_t k = 0; k < 2; ++k) {
    const double load = drive_.load(s) * moment_[node].dot(moment_axis(node, static_cast<int>(k)));
    torque += (sums.moment[2 * node + k] - load) * (after[k] - before[k]) / (2.0 * h);
  }
  return torque;
}

ForceBalance Equilibrium::balance(const Vector& z, double s) {
  positions(z, s);
  const ElementAssembly::Sums sums = elements_.evaluate(at_, drive_.load(s), nullptr);
  const std::vector<double> damping = damping_force(s);
  std::vector<Vec3> contact_on(layout_.owned_clusters, Vec3::Zero());
  const auto data = z.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < multipliers(); ++i)
    contact_on[i] = data[first + i] * contact(static_cast<int>(i), s, data[first + i]).normal;
  // Rows of three: contact, load, damping, pins, one a support; then the torque of each support; last the sums of
  // magnitudes, of the pins and of all.
  constexpr size_t contact_row = 0, load_row = 1, damping_row = 2, pin_row = 3, support_row = 4;
  const size_t supports = problem_.supports.size(), torques = 3 * (support_row + supports);
  const size_t count = torques + supports + 2;
  std::vector<double> mine(count, 0.0), all(count, 0.0);
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    Vec3 rest;  // what the supports of the cluster carry
    for (Eigen::Index d = 0; d < 3; ++d) {
      const size_t i = 3 * static_cast<size_t>(c) + static_cast<size_t>(d), column = static_cast<size_t>(d);
      const double dead = drive_.load(s) * load_[i] + (sums.pressure_force.empty() ? 0.0 : sums.pressure_force[i]);
      mine[3 * contact_row + column] += contact_on[c][d];
      mine[3 * load_row + column] += dead;
      mine[3 * damping_row + column] -= damping[i];
      mine.back() += std::abs(contact_on[c][d]) + std::abs(dead) + std::abs(damping[i]);
      rest[d] = sums.force[i] + damping[i] - dead - contact_on[c][d];
    }
    const Vec3 reactions = layout_.components_of_force(c, rest);
    for (Eigen::Index k = 0; k < 3; ++k) {
      const HeldComponent& held = layout_.held[c][static_cast<size_t>(k)];
      if (!held.held) continue;
      const Vec3 reaction = reactions[k] * layout_.direction(c, k);
      const size_t row = held.support < 0 ? pin_row : support_row + static_cast<size_t>(held.support);
      for (Eigen::Index d = 0; d < 3; ++d) mine[3 * row + static_cast<size_t>(d)] += reaction[d];
      mine.back() += std::abs(reactions[k]);
      if (held.support < 0)
        mine[count - 2] += std::abs(reactions[k]);
      else if (const auto& turn = problem_.supports[held.support].turn)
        mine[torques + static_cast<size_t>(held.support)] +=
            reaction.dot(turn->axis.cross(cluster_position(static_cast<size_t>(c)) - turn->point));
    }
  }
  mine.back() += moment_magnitudes(sums, s) / std::sqrt(mean_mass_);
  for (size_t n = 0; n < layout_.turned_by.size(); ++n)
    if (layout_.turned_by[n] >= 0 && layout_.node_cluster[n] < layout_.owned_clusters)
      mine[torques + static_cast<size_t>(layout_.turned_by[n])] += torque_of_director(sums, n, s);
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, static_cast<int>(count), mine.data(), all.data());
  const auto row = [&](size_t k) { return Vec3(all[3 * k], all[3 * k + 1], all[3 * k + 2]); };
  ForceBalance b;
  b.contact = row(contact_row);
  b.load = row(load_row);
  b.damping = row(damping_row);
  b.pins = row(pin_row);
  for (size_t k = 0; k < problem_.supports.size(); ++k) b.support.push_back(row(support_row + k));
  b.torque.assign(all.begin() + static_cast<std::ptrdiff_t>(torques), all.end() - 2);
  b.pin_magnitude = all[count - 2];
  // What 1e-4 mm at every node would take is the least that counts: at rest there are only forces of rounded positions.
  constexpr double resting = 1e-4;
  b.magnitude = std::max(all.back(), resting * diagonal_norm_);
  return b;
}

}  // namespace toile::solve
