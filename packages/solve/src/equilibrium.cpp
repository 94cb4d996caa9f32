#include "equilibrium.hpp"

#include <Eigen/Geometry>
#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::solve {

Equilibrium::Equilibrium(const Problem& problem, const State& start, const Held& held, const Drive& drive,
                         const SolverOptions& options, RCP<const Comm> comm, std::unique_ptr<LinearSolver> linear)
    : problem_(problem),
      options_(options),
      drive_(drive),
      layout_(problem, held, std::move(comm)),
      graph_(make_graph(layout_)),
      tangent_(rcp(new Matrix(graph_))),
      projected_(layout_.contact ? rcp(new Matrix(graph_)) : tangent_),
      projection_(layout_, *graph_),
      elements_(problem, layout_, *graph_),
      linear_(make_linear_solver(projected_, options.linear, std::move(linear))),
      start_(start) {
  tangent_->fillComplete(layout_.dof_map, layout_.dof_map);
  if (layout_.contact) projected_->fillComplete(layout_.dof_map, layout_.dof_map);
  mass_ = elements_.reference_areas();
  cluster_mass_.assign(layout_.clusters.size(), 0.0);
  for (size_t n = 0; n < mass_.size(); ++n) cluster_mass_[layout_.node_cluster[n]] += mass_[n];
  for (int c = 0; c < layout_.owned_clusters; ++c) offset_.push_back(start.offset[layout_.clusters[c]]);
  find_open_seams();
  find_diagonal_blocks();
  find_loads();
  if (layout_.has_shells()) find_frames();
  scale();
}

double Equilibrium::sum(double mine) const {
  double all = 0.0;
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

std::int64_t Equilibrium::place(LocalId row, LocalId column) const {
  if (row < 0 || column < 0) return -1;
  const auto local = graph_->getLocalGraphHost();
  const auto* begin = local.entries.data() + local.row_map(row);
  const auto* end = local.entries.data() + local.row_map(row + 1);
  return std::lower_bound(begin, end, column) - local.entries.data();
}

void Equilibrium::find_diagonal_blocks() {
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    std::array<std::array<std::int64_t, 3>, 3> places{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) places[i][j] = place(layout_.dof[c][i], layout_.dof[c][j]);
    diagonal_.push_back(places);
  }
}

void Equilibrium::find_loads() {
  std::vector<Vec3> force(problem_.mesh->nodes(), Vec3::Zero()), moment(force);
  for (const NodalLoad& load : problem_.loads)
    for (size_t i = 0; i < load.nodes.size(); ++i)
      (load.moment ? moment : force)[load.nodes[i]] += load.share[i] * load.value;
  load_.assign(3 * layout_.clusters.size(), 0.0);
  for (size_t n = 0; n < layout_.nodes.size(); ++n)
    for (int d = 0; d < 3; ++d)
      load_[3 * static_cast<size_t>(layout_.node_cluster[n]) + d] += force[layout_.nodes[n]][d];
  if (!layout_.has_shells()) return;
  for (const int node : layout_.nodes) moment_.push_back(moment[node]);
}

// Shells: where the directors start, and the rotary part of the shift.
void Equilibrium::find_frames() {
  for (const int node : layout_.nodes) {
    frames_.push_back(start_.frame[node]);
    rotation_previous_.insert(rotation_previous_.end(), start_.rotation[node].begin(), start_.rotation[node].end());
  }
  for (const BlockLaw& law : problem_.laws)
    if (law.is_shell()) rotary_ = std::max(rotary_, law.material->thickness() * law.material->thickness() / 12.0);
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    std::array<std::int64_t, 2> places = {-1, -1};
    if (layout_.node_cluster[n] < layout_.owned_clusters)
      for (size_t k = 0; k < 2; ++k) places[k] = place(layout_.rotation[n][k], layout_.rotation[n][k]);
    rotation_diagonal_.push_back(places);
  }
  positions(*start_vector(), 0.0);
  elements_.set_frames(frames_);
  elements_.find_frozen(at_);
  elements_.adopt_frozen();
}

// Means of the undamped start tangent and of the lumped area: the measures of contact stiffness, damping and shifts. A
// rotation counts as the displacement that it makes at the distance of two nodes; the means are of displacements where
// there are free ones.
void Equilibrium::scale() {
  const RCP<Vector> z = start_vector();
  positions(*z, 0.0);
  x_previous_ = at_.x;
  auto local = tangent_->getLocalMatrixHost();
  double* values = local.values.data();
  std::fill_n(values, local.values.extent(0), 0.0);
  elements_.evaluate(at_, drive_.load(0.0), values);
  double diagonal = 0.0, squared = 0.0, mass = 0.0, rows = 0.0, all_mass = 0.0;
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    all_mass += cluster_mass_[c];
    for (int i = 0; i < 3; ++i)
      if (diagonal_[c][i][i] >= 0) {
        const double entry = values[diagonal_[c][i][i]];
        diagonal += entry;
        squared += entry * entry;
        mass += cluster_mass_[c];
        rows += 1.0;
      }
  }
  const double count = sum(rows);
  mean_mass_ = count > 0.0 ? sum(mass) / count : sum(all_mass) / static_cast<double>(problem_.clusters.size());
  double turning = 0.0, rotations = 0.0;
  for (const auto& places : rotation_diagonal_)
    for (const std::int64_t place : places)
      if (place >= 0) {
        const double entry = values[place] / mean_mass_;
        turning += entry;
        squared += entry * entry;
        rotations += 1.0;
      }
  mean_diagonal_ = count > 0.0 ? sum(diagonal) / count : sum(turning) / std::max(1.0, sum(rotations));
  diagonal_norm_ = std::sqrt(sum(squared));
  stiffness_ = problem_.contact.relative_stiffness * std::abs(mean_diagonal_);
}

Vec3 Equilibrium::separation(int node, int cluster, double s) const {
  const int master = problem_.clusters[layout_.clusters[cluster]].front();
  return (1.0 - drive_.seam(s)) * (problem_.mesh->placed[node] - problem_.mesh->placed[master]);
}

Vec3 Equilibrium::cluster_position(size_t c) const {
  return Vec3(y_[3 * c], y_[3 * c + 1], y_[3 * c + 2]);
}

double Equilibrium::held_position(int cluster, int component, double s) const {
  const HeldComponent& h = layout_.held[cluster][component];
  const double load = drive_.load(s);
  return h.position(h.support < 0 ? load : problem_.supports[static_cast<size_t>(h.support)].path.share(load));
}

// From the unknowns of a vector and what is held.
void Equilibrium::set_position(int c, const double* z, double s) {
  Vec3 components;
  for (int i = 0; i < 3; ++i) components[i] = layout_.held[c][i].held ? held_position(c, i, s) : z[layout_.dof[c][i]];
  const Vec3 y = layout_.position(c, components);
  std::copy_n(y.data(), 3, &y_[3 * static_cast<size_t>(c)]);
}

void Equilibrium::positions(const Vector& z, double s) {
  const RCP<const Vector> owned = z.offsetView(layout_.dof_map, 0)->getVector(0);
  Vector overlap(layout_.overlap_map);
  overlap.doImport(*owned, *layout_.importer, Tpetra::INSERT);
  const auto data = overlap.getData();
  y_.resize(3 * layout_.clusters.size());
  for (int c = 0; c < static_cast<int>(layout_.clusters.size()); ++c) set_position(c, data.getRawPtr(), s);
  at_.x.resize(3 * layout_.nodes.size());
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    const int c = layout_.node_cluster[n];
    const Vec3 p = cluster_position(c) + separation(layout_.nodes[n], c, s);
    std::copy_n(p.data(), 3, &at_.x[3 * n]);
  }
  at_.rotation.resize(2 * layout_.rotation.size());
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    const std::array<double, 2> held = held_rotation(n, s);
    for (size_t k = 0; k < 2; ++k) {
      const LocalId d = layout_.rotation[n][k];
      at_.rotation[2 * n + k] = d >= 0 ? data[d] - rotation_previous_[2 * n + k] : held[k];
    }
  }
}

// Of a held director since the start of the step: none, unless its clamp turns.
std::array<double, 2> Equilibrium::held_rotation(size_t node, double s) const {
  const int support = layout_.turned_by.empty() ? -1 : layout_.turned_by[node];
  if (support < 0) return {0.0, 0.0};
  const Support& clamp = problem_.supports[static_cast<size_t>(support)];
  const double since = clamp.path.share(drive_.load(s)) - clamp.path.share(drive_.load(s_previous_));
  const Vec3 before = frames_[node].row(2);
  return rotation_to(frames_[node], Eigen::AngleAxisd(since * clamp.turn->angle, clamp.turn->axis) * before);
}

// Axis in space about which the unknown w_k turns a node's director, d_n x t_k. Exact at w = 0 and, for a director that
// turns about one axis, at any w.
Vec3 Equilibrium::moment_axis(size_t node, int k) const {
  const Frame& frame = frames_[node];
  return frame.row(2).transpose().cross(frame.row(k).transpose());
}

double Equilibrium::interval(double s) const {
  return s > s_previous_ ? s - s_previous_ : smallest_interval_;
}

std::vector<double> Equilibrium::damping_force(double s) const {
  std::vector<double> force(3 * layout_.clusters.size(), 0.0);
  const double factor = damping_ / interval(s);
  for (size_t n = 0; n < layout_.nodes.size(); ++n)
    for (int d = 0; d < 3; ++d)
      force[3 * static_cast<size_t>(layout_.node_cluster[n]) + d] +=
          factor * mass_[n] * (at_.x[3 * n + d] - x_previous_[3 * n + d]);
  return force;
}

// An open seam touches the body at the mean of its nodes. When placed, that mean lies inside the body by the sagitta of
// the opening's chord, which fades with the square of the opening; at closing the condition is exact.
void Equilibrium::find_open_seams() {
  mean_separation_.assign(multipliers(), Vec3::Zero());
  placed_depth_.assign(multipliers(), 0.0);
  for (size_t c = 0; c < multipliers(); ++c) {
    const std::vector<int>& members = problem_.clusters[layout_.clusters[c]];
    if (members.size() == 1) continue;
    const Vec3& master = problem_.mesh->placed[members.front()];
    for (const int n : members)
      mean_separation_[c] += (problem_.mesh->placed[n] - master) / static_cast<double>(members.size());
    placed_depth_[c] = std::min(0.0, problem_.surface->closest(master + mean_separation_[c]).gap);
  }
}

double Equilibrium::length_of_free_part(int c, const Vec3& direction) const {
  const Vec3 part = layout_.components_of_force(c, direction);
  double squared = 0.0;
  for (int d = 0; d < 3; ++d)
    if (layout_.dof[c][d] >= 0) squared += part[d] * part[d];
  return std::sqrt(squared);
}

contact::NodeContact Equilibrium::contact(int c, double s, double multiplier) const {
  contact::NodeContact held;  // its support carries it, wherever it lies
  held.complementarity = multiplier / stiffness_;
  const std::array<LocalId, 3>& dof = layout_.dof[c];
  if (std::all_of(dof.begin(), dof.end(), [](LocalId d) { return d < 0; })) return held;
  const double open = 1.0 - drive_.seam(s);
  const Vec3 x = cluster_position(static_cast<size_t>(c)) + open * mean_separation_[c];
  const contact::NodeContact free =
      contact::evaluate(*problem_.surface, x, offset_[c] + open * open * placed_depth_[c], multiplier, stiffness_);
  return length_of_free_part(c, free.normal) < ContactProjection::tangential * free.normal.norm() ? held : free;
}

void Equilibrium::residual(const Vector& z, double s, Vector& f) {
  positions(z, s);
  ElementAssembly::Sums sums = elements_.evaluate(at_, drive_.load(s), nullptr);
  strain_energy_ = sum(sums.energy);
  extrapolated_ = static_cast<int>(sum(sums.extrapolated));
  magnitude_ = std::move(sums.magnitude);
  moment_magnitude_ = std::move(sums.moment_magnitude);
  std::vector<double>& force = sums.force;
  for (size_t i = 0; i < force.size(); ++i) force[i] -= drive_.load(s) * load_[i];
  for (size_t i = 0; i < sums.pressure_force.size(); ++i) force[i] -= sums.pressure_force[i];
  if (damping_ > 0.0) {
    const std::vector<double> damping = damping_force(s);
    for (size_t i = 0; i < force.size(); ++i) force[i] += damping[i];
  }
  const auto multiplier = z.getData();
  auto out = f.getDataNonConst();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < multipliers(); ++i) {
    const contact::NodeContact c = contact(static_cast<int>(i), s, multiplier[first + i]);
    for (size_t d = 0; d < 3; ++d) force[3 * i + d] += c.residual[static_cast<Eigen::Index>(d)];
    out[first + i] = c.complementarity;
  }
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    const Vec3 part = layout_.components_of_force(c, Eigen::Map<const Vec3>(&force[3 * static_cast<size_t>(c)]));
    for (int d = 0; d < 3; ++d)
      if (layout_.dof[c][d] >= 0) out[layout_.dof[c][d]] = part[d];
  }
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (int k = 0; k < 2; ++k)
      if (layout_.rotation[n][k] >= 0)
        out[layout_.rotation[n][k]] = sums.moment[2 * n + k] - drive_.load(s) * moment_[n].dot(moment_axis(n, k));
  }
}

double Equilibrium::load_potential(const ElementAssembly::Sums& sums, double s) const {
  double work = 0.0;
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int d = 0; d < 3; ++d) work += load_[3 * static_cast<size_t>(c) + d] * y_[3 * static_cast<size_t>(c) + d];
  for (size_t n = 0; n < layout_.rotation.size(); ++n)
    for (int k = 0; k < 2 && layout_.node_cluster[n] < layout_.owned_clusters; ++k)
      work += moment_[n].dot(moment_axis(n, k)) * at_.rotation[2 * n + k];
  return sums.pressure_potential - drive_.load(s) * work;
}

double Equilibrium::energy(const Vector& z, const Vector& frozen, double s) {
  if (elements_.has_pressure_edges()) {
    positions(frozen, s);
    elements_.hold_pressure_edges(at_);
  }
  positions(z, s);
  const ElementAssembly::Sums sums = elements_.evaluate(at_, drive_.load(s), nullptr);
  double total = sums.energy + load_potential(sums, s);
  const double factor = damping_ > 0.0 ? 0.5 * damping_ / interval(s) : 0.0;
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (int d = 0; d < 3; ++d) {
      const double step = at_.x[3 * n + d] - x_previous_[3 * n + d];
      total += factor * mass_[n] * step * step;
    }
  }
  const auto multiplier = frozen.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < multipliers(); ++i) total += contact(static_cast<int>(i), s, multiplier[first + i]).energy;
  return sum(total);
}

void Equilibrium::add_to_diagonal(double factor, double* values) const {
  for (int c = 0; c < layout_.owned_clusters; ++c)
    for (int i = 0; i < 3; ++i)
      if (diagonal_[c][i][i] >= 0) values[diagonal_[c][i][i]] += factor * cluster_mass_[c];
}

void Equilibrium::add_shift(double factor, double* values) const {
  add_to_diagonal(factor, values);
  for (size_t n = 0; n < rotation_diagonal_.size(); ++n)
    for (const std::int64_t diagonal : rotation_diagonal_[n])
      if (diagonal >= 0) values[diagonal] += factor * rotary_ * mass_[n];
}

// The curvature of the body under the contact forces; the conditions themselves go into the projection.
void Equilibrium::add_contact_tangent(const Vector& z, double s, double* values) {
  const auto multiplier = z.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  std::vector<Vec3> normals(multipliers(), Vec3::Zero());
  free_part_.assign(multipliers(), 0.0);
  for (size_t i = 0; i < multipliers(); ++i) {
    const contact::NodeContact c = contact(static_cast<int>(i), s, multiplier[first + i]);
    if (!c.active) continue;
    normals[i] = layout_.components_of_force(static_cast<int>(i), c.normal);
    free_part_[i] = length_of_free_part(static_cast<int>(i), c.normal);
    Eigen::Matrix3d curvature = c.curvature;
    if (layout_.is_turned(static_cast<int>(i)))
      curvature = layout_.basis[i].along.transpose() * curvature * layout_.basis[i].along;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        if (diagonal_[i][a][b] >= 0) values[diagonal_[i][a][b]] += curvature(a, b);
  }
  projection_.set(normals);
}

void Equilibrium::linearise(const Vector& z, double s) {
  positions(z, s);
  auto local = tangent_->getLocalMatrixHost();
  double* values = local.values.data();
  std::fill_n(values, local.values.extent(0), 0.0);
  elements_.evaluate(at_, drive_.load(s), values);
  if (damping_ > 0.0) add_to_diagonal(damping_ / interval(s), values);
  if (layout_.contact) {
    add_contact_tangent(z, s, values);
    projection_.project(*tangent_, std::abs(mean_diagonal_), *projected_);
  }
  const bool fresh = want_fresh_ || !seek_minimum_;
  linear_->update(fresh);
  if (fresh) unshifted_pivots_ = -1;
  factorise_positive();
  want_fresh_ = false;
}

// A direction of descent needs a positive definite tangent: as long as the factorisation fails or shows negative
// pivots, a multiple of the lumped area is added. In a stable equilibrium none is left, and the shift is gone. It
// starts small: a tube of even fabric that slides round a body along itself changes its energy by its discretisation
// error only, and a larger shift lets it creep.
void Equilibrium::factorise_positive() {
  if (!linear_->is_fresh() && !linear_->failed()) return;  // a kept factorisation
  const auto indefinite = [this] { return linear_->failed() || linear_->negative_pivots().value_or(0) > 0; };
  unshifted_pivots_ = linear_->failed() ? -1 : linear_->negative_pivots().value_or(-1);
  if (!indefinite() || !seek_minimum_) return;
  double* values = projected_->getLocalMatrixHost().values.data();
  const double least = 1e-8 * std::abs(mean_diagonal_) / mean_mass_;
  double added = 0.0;
  for (double shift = std::max(least, 0.1 * last_shift_); indefinite() && shift < 1e12 * least; shift *= 10.0) {
    add_shift(shift - added, values);
    added = last_shift_ = shift;
    linear_->update(true);
  }
}

bool Equilibrium::solve(const Vector& b, Vector& dz) {
  const RCP<const Vector> b_x = b.offsetView(layout_.dof_map, 0)->getVector(0);
  const RCP<Vector> dx = dz.offsetViewNonConst(layout_.dof_map, 0)->getVectorNonConst(0);
  const size_t first = layout_.dof_map->getNodeNumElements();
  const auto right = b.getData();
  const double k = std::abs(mean_diagonal_);

  // dx = d + P w with d the prescribed normal steps: P K P w = P (b - K d).
  Vector normal_step(layout_.dof_map), rhs(*b_x, Teuchos::Copy);
  for (size_t c = 0; c < multipliers(); ++c)
    if (projection_.active(static_cast<int>(c)))
      projection_.add(normal_step, static_cast<int>(c), right[first + c] / free_part(c));
  if (layout_.contact) {
    tangent_->apply(normal_step, rhs, Teuchos::NO_TRANS, -1.0, 1.0);
    projection_.project(rhs);
    rhs.update(k, normal_step, 1.0);
  }
  // An ascent shows a tangent that is not positive definite, which a kept factorisation cannot tell.
  const auto descends = [&] { return rhs.dot(*dx) > k * normal_step.dot(normal_step); };
  if (!linear_->solve(rhs, *dx) || (!linear_->is_fresh() && !descends())) {
    if (linear_->is_fresh()) return false;
    linear_->update(true);
    factorise_positive();
    if (!linear_->solve(rhs, *dx)) return false;
  }
  if (!layout_.contact) return true;
  Vector force(layout_.dof_map);
  tangent_->apply(*dx, force);
  force.update(-1.0, *b_x, 1.0);
  const auto step = dz.getDataNonConst();
  for (size_t c = 0; c < multipliers(); ++c) {
    step[first + c] = stiffness_ * right[first + c];
    if (projection_.active(static_cast<int>(c)))
      step[first + c] += projection_.component(force, static_cast<int>(c)) / free_part(c);
  }
  return true;
}

void Equilibrium::apply(const Vector& x, Vector& y) const {
  const RCP<const Vector> dx = x.offsetView(layout_.dof_map, 0)->getVector(0);
  const RCP<Vector> f = y.offsetViewNonConst(layout_.dof_map, 0)->getVectorNonConst(0);
  tangent_->apply(*dx, *f);
  const auto step = x.getData();
  const size_t first = layout_.dof_map->getNodeNumElements();
  for (size_t i = 0; i < multipliers(); ++i) {
    const int c = static_cast<int>(i);
    double condition = step[first + i] / stiffness_;
    if (projection_.active(c)) {
      condition = projection_.component(*dx, c) * free_part(i);
      projection_.add(*f, c, (stiffness_ * condition - step[first + i]) * free_part(i));
    }
    y.getDataNonConst()[first + i] = condition;
  }
}

void Equilibrium::retract(Vector& z, double s) {
  auto data = z.getDataNonConst();
  for (size_t i = 0; i < multipliers(); ++i)
    if (projection_.active(static_cast<int>(i))) retract_cluster(i, s, data.getRawPtr());
}

void Equilibrium::retract_cluster(size_t i, double s, double* z) {
  constexpr int rounds = 3;  // the gap's error falls by its square
  const int c = static_cast<int>(i);
  for (int round = 0; round < rounds; ++round) {
    set_position(c, z, s);
    const contact::NodeContact at = contact(c, s, 0.0);
    const double free = length_of_free_part(c, at.normal);
    if (free < ContactProjection::tangential) return;
    const Vec3 normal = layout_.components_of_force(c, at.normal);
    for (int d = 0; d < 3; ++d)
      if (layout_.dof[c][d] >= 0) z[layout_.dof[c][d]] -= at.gap * normal[d] / (free * free);
  }
}

double Equilibrium::slope_along_surface(const Vector& f, const Vector& dz) const {
  Vector along(*dz.offsetView(layout_.dof_map, 0)->getVector(0), Teuchos::Copy);
  if (layout_.contact) projection_.project(along);
  return f.offsetView(layout_.dof_map, 0)->getVector(0)->dot(along);
}

}  // namespace toile::solve
