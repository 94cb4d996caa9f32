#include "equilibrium.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::solve {

Equilibrium::Equilibrium(const Problem& problem, const State& start, std::vector<std::array<HeldComponent, 3>> held,
                         const Drive& drive, bool seams_closed,
                         const SolverOptions& options, RCP<const Comm> comm)
    : problem_(problem),
      options_(options),
      drive_(drive),
      layout_(problem, std::move(held), seams_closed, std::move(comm)),
      graph_(make_graph(layout_)),
      tangent_(rcp(new Matrix(graph_))),
      elements_(problem, layout_, *graph_),
      linear_(tangent_, options.linear),
      start_(start) {
  tangent_->fillComplete(layout_.dof_map, layout_.dof_map);
  mass_ = elements_.reference_areas();
  cluster_mass_.assign(layout_.clusters.size(), 0.0);
  for (size_t n = 0; n < mass_.size(); ++n) cluster_mass_[layout_.node_cluster[n]] += mass_[n];
  for (const ContactNode& c : layout_.contact_nodes) offset_.push_back(start.offset[c.node]);
  find_diagonal_blocks();
  find_loads();
  scale();
}

double Equilibrium::sum(double mine) const {
  double all = 0.0;
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

void Equilibrium::find_diagonal_blocks() {
  const auto local = graph_->getLocalGraphHost();
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    std::array<std::array<std::int64_t, 3>, 3> places{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const LocalId row = layout_.dof[c][i], column = layout_.dof[c][j];
        places[i][j] = -1;
        if (row < 0 || column < 0) continue;
        const auto* begin = local.entries.data() + local.row_map(row);
        const auto* end = local.entries.data() + local.row_map(row + 1);
        places[i][j] = std::lower_bound(begin, end, column) - local.entries.data();
      }
    diagonal_.push_back(places);
  }
}

void Equilibrium::find_loads() {
  std::vector<Vec3> nodal(problem_.mesh->nodes(), Vec3::Zero());
  for (const EdgeLoad& load : problem_.loads)
    for (size_t i = 0; i + 1 < load.nodes.size(); ++i) {
      const double length =
          (problem_.mesh->pattern[load.nodes[i + 1]] - problem_.mesh->pattern[load.nodes[i]]).norm();
      nodal[load.nodes[i]] += 0.5 * length * load.traction;
      nodal[load.nodes[i + 1]] += 0.5 * length * load.traction;
    }
  load_.assign(3 * layout_.clusters.size(), 0.0);
  for (size_t n = 0; n < layout_.nodes.size(); ++n)
    for (int d = 0; d < 3; ++d) load_[3 * static_cast<size_t>(layout_.node_cluster[n]) + d] += nodal[layout_.nodes[n]][d];
}

// Means of the undamped start tangent and of the lumped area: the measures of contact stiffness and damping.
void Equilibrium::scale() {
  const RCP<Vector> z = start_vector();
  positions(*z, 0.0);
  x_previous_ = x_;
  auto local = tangent_->getLocalMatrixHost();
  double* values = local.values.data();
  std::fill_n(values, local.values.extent(0), 0.0);
  elements_.evaluate(x_, values);
  double diagonal = 0.0, mass = 0.0, rows = 0.0;
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int i = 0; i < 3; ++i)
      if (diagonal_[c][i][i] >= 0) {
        diagonal += values[diagonal_[c][i][i]];
        mass += cluster_mass_[c];
        rows += 1.0;
      }
  const double count = std::max(1.0, sum(rows));
  mean_diagonal_ = sum(diagonal) / count;
  mean_mass_ = sum(mass) / count;
  stiffness_ = problem_.contact.relative_stiffness * std::abs(mean_diagonal_);
}

Vec3 Equilibrium::separation(int node, int cluster, double s) const {
  const int master = problem_.clusters[layout_.clusters[cluster]].front();
  return (1.0 - drive_.seam(s)) * (problem_.mesh->placed[node] - problem_.mesh->placed[master]);
}

Vec3 Equilibrium::cluster_position(size_t c) const { return Vec3(y_[3 * c], y_[3 * c + 1], y_[3 * c + 2]); }

RCP<Vector> Equilibrium::vector_of(const State& state) const {
  const RCP<Vector> z = rcp(new Vector(layout_.state_map));
  auto data = z->getDataNonConst();
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int i = 0; i < 3; ++i)
      if (layout_.dof[c][i] >= 0) data[layout_.dof[c][i]] = state.position[layout_.clusters[c]][i];
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < layout_.contact_nodes.size(); ++i)
    data[first + i] = state.contact_force[layout_.contact_nodes[i].node];
  return z;
}

void Equilibrium::positions(const Vector& z, double s) {
  const RCP<const Vector> owned = z.offsetView(layout_.dof_map, 0)->getVector(0);
  Vector overlap(layout_.overlap_map);
  overlap.doImport(*owned, *layout_.importer, Tpetra::INSERT);
  const auto data = overlap.getData();
  y_.resize(3 * layout_.clusters.size());
  for (size_t c = 0; c < layout_.clusters.size(); ++c)
    for (int i = 0; i < 3; ++i) {
      const HeldComponent& h = layout_.held[c][i];
      y_[3 * c + i] = h.held ? h.base + drive_.load(s) * h.displacement : data[layout_.dof[c][i]];
    }
  x_.resize(3 * layout_.nodes.size());
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    const int c = layout_.node_cluster[n];
    const Vec3 p = cluster_position(c) + separation(layout_.nodes[n], c, s);
    std::copy_n(p.data(), 3, &x_[3 * n]);
  }
}

double Equilibrium::interval(double s) const { return s > s_previous_ ? s - s_previous_ : smallest_interval_; }

std::vector<double> Equilibrium::damping_force(double s) const {
  std::vector<double> force(3 * layout_.clusters.size(), 0.0);
  const double factor = damping_ / interval(s);
  for (size_t n = 0; n < layout_.nodes.size(); ++n)
    for (int d = 0; d < 3; ++d)
      force[3 * static_cast<size_t>(layout_.node_cluster[n]) + d] +=
          factor * mass_[n] * (x_[3 * n + d] - x_previous_[3 * n + d]);
  return force;
}

contact::NodeContact Equilibrium::contact(size_t i, double s, double multiplier) const {
  const ContactNode& c = layout_.contact_nodes[i];
  const Vec3 x = cluster_position(c.cluster) + separation(c.node, c.cluster, s);
  return contact::evaluate(*problem_.surface, x, offset_[i], multiplier, stiffness_);
}

void Equilibrium::residual(const Vector& z, double s, Vector& f) {
  positions(z, s);
  ElementAssembly::Sums sums = elements_.evaluate(x_, nullptr);
  strain_energy_ = sum(sums.energy);
  extrapolated_ = sums.extrapolated;
  magnitude_ = std::move(sums.magnitude);
  std::vector<double>& force = sums.force;
  for (size_t i = 0; i < force.size(); ++i) force[i] -= drive_.load(s) * load_[i];
  if (damping_ > 0.0) {
    const std::vector<double> damping = damping_force(s);
    for (size_t i = 0; i < force.size(); ++i) force[i] += damping[i];
  }
  const auto multiplier = z.getData();
  auto out = f.getDataNonConst();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < layout_.contact_nodes.size(); ++i) {
    const contact::NodeContact c = contact(i, s, multiplier[first + i]);
    for (int d = 0; d < 3; ++d)
      force[3 * static_cast<size_t>(layout_.contact_nodes[i].cluster) + d] += c.residual[d];
    out[first + i] = c.complementarity;
  }
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int d = 0; d < 3; ++d)
      if (layout_.dof[c][d] >= 0) out[layout_.dof[c][d]] = force[3 * static_cast<size_t>(c) + d];
}

double Equilibrium::energy(const Vector& z, const Vector& frozen, double s) {
  positions(z, s);
  const ElementAssembly::Sums sums = elements_.evaluate(x_, nullptr);
  double total = sums.energy;
  const double factor = damping_ > 0.0 ? 0.5 * damping_ / interval(s) : 0.0;
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (int d = 0; d < 3; ++d) {
      const double step = x_[3 * n + d] - x_previous_[3 * n + d];
      total += factor * mass_[n] * step * step;
    }
  }
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int d = 0; d < 3; ++d)
      total -= drive_.load(s) * load_[3 * static_cast<size_t>(c) + d] * y_[3 * static_cast<size_t>(c) + d];
  const auto multiplier = frozen.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < layout_.contact_nodes.size(); ++i) total += contact(i, s, multiplier[first + i]).energy;
  return sum(total);
}

void Equilibrium::add_to_diagonal(double factor, double* values) const {
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int i = 0; i < 3; ++i)
      if (diagonal_[c][i][i] >= 0) values[diagonal_[c][i][i]] += factor * cluster_mass_[c];
}

void Equilibrium::add_contact_tangent(const Vector& z, double s, double* values) {
  const auto multiplier = z.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  active_.clear();
  for (size_t i = 0; i < layout_.contact_nodes.size(); ++i) {
    const contact::NodeContact c = contact(i, s, multiplier[first + i]);
    const int cluster = layout_.contact_nodes[i].cluster;
    active_.push_back({layout_.dof[cluster], c.normal, c.active});
    for (int a = 0; a < 3 && c.active; ++a)
      for (int b = 0; b < 3; ++b)
        if (diagonal_[cluster][a][b] >= 0) values[diagonal_[cluster][a][b]] += c.tangent(a, b);
  }
}

void Equilibrium::linearise(const Vector& z, double s) {
  positions(z, s);
  auto local = tangent_->getLocalMatrixHost();
  double* values = local.values.data();
  std::fill_n(values, local.values.extent(0), 0.0);
  elements_.evaluate(x_, values);
  if (damping_ > 0.0) add_to_diagonal(damping_ / interval(s), values);
  add_contact_tangent(z, s, values);
  linear_.update(want_fresh_);
  factorise_positive();
  want_fresh_ = false;
}

// A direction of descent needs a positive definite tangent: as long as the factorisation shows negative pivots, a
// multiple of the lumped area is added. In a stable equilibrium none is left, and the shift is gone.
void Equilibrium::factorise_positive() {
  if (!linear_.is_fresh()) return;
  unshifted_pivots_ = linear_.negative_pivots();
  double* values = tangent_->getLocalMatrixHost().values.data();
  double shift = 1e-3 * std::abs(mean_diagonal_) / mean_mass_;
  for (int attempt = 0; attempt < 12 && linear_.negative_pivots() > 0; ++attempt) {
    add_to_diagonal(shift, values);
    shift *= 4.0;
    linear_.update(true);
  }
}

bool Equilibrium::solve(const Vector& b, Vector& dz) {
  const RCP<const Vector> b_x = b.offsetView(layout_.dof_map, 0)->getVector(0);
  const RCP<Vector> dx = dz.offsetViewNonConst(layout_.dof_map, 0)->getVectorNonConst(0);
  if (!linear_.solve(*b_x, *dx)) {
    if (linear_.is_fresh()) return false;
    linear_.update(true);
    factorise_positive();
    if (!linear_.solve(*b_x, *dx)) return false;
  }
  const auto step = dz.getDataNonConst();
  const auto right = b.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < active_.size(); ++i) {
    double normal_step = 0.0;
    for (int d = 0; d < 3; ++d)
      if (active_[i].dof[d] >= 0) normal_step += active_[i].normal[d] * step[active_[i].dof[d]];
    step[first + i] = stiffness_ * (right[first + i] - (active_[i].active ? normal_step : 0.0));
  }
  return true;
}

void Equilibrium::apply(const Vector& x, Vector& y) const {
  const RCP<const Vector> dx = x.offsetView(layout_.dof_map, 0)->getVector(0);
  const RCP<Vector> f = y.offsetViewNonConst(layout_.dof_map, 0)->getVectorNonConst(0);
  tangent_->apply(*dx, *f);
  const auto step = x.getData();
  auto out = y.getDataNonConst();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < active_.size(); ++i) {
    out[first + i] = step[first + i] / stiffness_;
    for (int d = 0; d < 3 && active_[i].active; ++d)
      if (active_[i].dof[d] >= 0) out[first + i] += active_[i].normal[d] * step[active_[i].dof[d]];
  }
}

double Equilibrium::force_slope(const Vector& f, const Vector& dz) const {
  return f.offsetView(layout_.dof_map, 0)->getVector(0)->dot(*dz.offsetView(layout_.dof_map, 0)->getVector(0));
}

int Equilibrium::global_contact_nodes() const {
  return static_cast<int>(layout_.state_map->getGlobalNumElements() - layout_.dof_map->getGlobalNumElements());
}

Imbalance Equilibrium::imbalance(const Vector& f) const {
  double mine[2] = {0.0, 0.0};
  const auto data = f.getData();
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int d = 0; d < 3; ++d) {
      if (layout_.dof[c][d] < 0) continue;
      const double scale = magnitude_[3 * static_cast<size_t>(c) + d];
      mine[0] += data[layout_.dof[c][d]] * data[layout_.dof[c][d]];
      mine[1] += scale * scale;
    }
  double gap = 0.0;
  for (size_t i = layout_.dof_map->getNodeNumElements(); i < static_cast<size_t>(data.size()); ++i)
    gap = std::isnan(data[i]) ? data[i] : std::max(gap, std::abs(data[i]));
  Imbalance all;
  double sums[2], largest = 0.0;
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, 2, mine, sums);
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, gap, Teuchos::outArg(largest));
  all.force = std::sqrt(sums[0]);
  all.force_scale = std::sqrt(sums[1]);
  all.gap = largest;
  return all;
}

void Equilibrium::start_step(const Vector& converged, double s) {
  positions(converged, s);
  x_previous_ = x_;
  s_previous_ = s;
  want_fresh_ = true;
}

double Equilibrium::dissipation(const Vector& z, double s) {
  positions(z, s);
  double total = 0.0;
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (int d = 0; d < 3; ++d) {
      const double step = x_[3 * n + d] - x_previous_[3 * n + d];
      total += mass_[n] * step * step;
    }
  }
  return damping_ / interval(s) * sum(total);
}

double Equilibrium::update_offsets(const Vector& z, double s) {
  if (!problem_.contact.offset_by_half_thickness) return 0.0;
  positions(z, s);
  const std::vector<double> thickness = elements_.nodal_thickness(x_);
  std::vector<double> by_node(problem_.mesh->nodes(), 0.0);
  for (size_t n = 0; n < layout_.nodes.size(); ++n) by_node[layout_.nodes[n]] = thickness[n];
  double mine = 0.0, largest = 0.0;
  for (size_t i = 0; i < offset_.size(); ++i) {
    const double offset = 0.5 * by_node[layout_.contact_nodes[i].node];
    mine = std::max(mine, std::abs(offset - offset_[i]));
    offset_[i] = offset;
  }
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(largest));
  want_fresh_ = true;
  return largest;
}

void Equilibrium::balance_multipliers(Vector& z, double s) {
  positions(z, s);
  const ElementAssembly::Sums sums = elements_.evaluate(x_, nullptr);
  constexpr double touching = 0.1;  // mm
  auto data = z.getDataNonConst();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < layout_.contact_nodes.size(); ++i) {
    const size_t c = 3 * static_cast<size_t>(layout_.contact_nodes[i].cluster);
    const Vec3 internal(sums.force[c], sums.force[c + 1], sums.force[c + 2]);
    data[first + i] = contact::balancing_multiplier(contact(i, s, 0.0), internal, touching);
  }
}

State Equilibrium::state(const Vector& z, double s) const {
  State state;
  const size_t clusters = problem_.clusters.size(), nodes = static_cast<size_t>(problem_.mesh->nodes());
  std::vector<double> mine(3 * clusters + 2 * nodes, 0.0), all(mine.size());
  const auto data = z.getData();
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int i = 0; i < 3; ++i) {
      const HeldComponent& h = layout_.held[c][i];
      mine[3 * static_cast<size_t>(layout_.clusters[c]) + i] =
          h.held ? h.base + drive_.load(s) * h.displacement : data[layout_.dof[c][i]];
    }
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < layout_.contact_nodes.size(); ++i) {
    mine[3 * clusters + layout_.contact_nodes[i].node] = data[first + i];
    mine[3 * clusters + nodes + layout_.contact_nodes[i].node] = offset_[i];
  }
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  for (size_t c = 0; c < clusters; ++c) state.position.emplace_back(all[3 * c], all[3 * c + 1], all[3 * c + 2]);
  state.contact_force.assign(all.begin() + 3 * clusters, all.begin() + 3 * clusters + nodes);
  state.offset.assign(all.begin() + 3 * clusters + nodes, all.end());
  state.seam = drive_.seam(s);
  state.load = drive_.load(s);
  return state;
}

ForceBalance Equilibrium::balance(const Vector& z, double s) {
  positions(z, s);
  const ElementAssembly::Sums sums = elements_.evaluate(x_, nullptr);
  const std::vector<double> damping = damping_force(s);
  std::vector<Vec3> contact_on(layout_.owned_clusters, Vec3::Zero());
  const auto data = z.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < layout_.contact_nodes.size(); ++i) {
    const contact::NodeContact c = contact(i, s, data[first + i]);
    contact_on[layout_.contact_nodes[i].cluster] += data[first + i] * c.normal;
  }
  // Rows of three: contact, load, damping, pins, one a support; last the sum of magnitudes.
  constexpr size_t contact_row = 0, load_row = 1, damping_row = 2, pin_row = 3, support_row = 4;
  const size_t count = 3 * (support_row + problem_.supports.size()) + 1;
  std::vector<double> mine(count, 0.0), all(count, 0.0);
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (size_t d = 0; d < 3; ++d) {
      const size_t i = 3 * static_cast<size_t>(c) + d;
      const double dead = drive_.load(s) * load_[i];
      mine[3 * contact_row + d] += contact_on[c][d];
      mine[3 * load_row + d] += dead;
      mine[3 * damping_row + d] -= damping[i];
      mine.back() += std::abs(contact_on[c][d]) + std::abs(dead) + std::abs(damping[i]);
      const HeldComponent& held = layout_.held[c][d];
      if (!held.held) continue;
      const double reaction = sums.force[i] + damping[i] - dead - contact_on[c][d];
      mine[3 * (held.support < 0 ? pin_row : support_row + static_cast<size_t>(held.support)) + d] += reaction;
      mine.back() += std::abs(reaction);
    }
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, static_cast<int>(count), mine.data(), all.data());
  const auto row = [&](size_t k) { return Vec3(all[3 * k], all[3 * k + 1], all[3 * k + 2]); };
  ForceBalance b;
  b.contact = row(contact_row);
  b.load = row(load_row);
  b.damping = row(damping_row);
  b.pins = row(pin_row);
  for (size_t k = 0; k < problem_.supports.size(); ++k) b.support.push_back(row(support_row + k));
  b.magnitude = all.back();
  return b;
}

}  // namespace toile::solve
