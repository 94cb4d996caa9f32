#include "equilibrium/equilibrium.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "equilibrium/unknowns.hpp"

namespace toile::solve {

namespace {

constexpr double rounded_position = 1e-12;  // mm

/// Membranes that nothing loads are at rest where no force would move its node further, mm: their relative residual is
/// then of round-off alone, and a slack membrane has no shape of its own to settle it.
constexpr double resting_distance = 1e-7;

/// What rounded positions leave of a balance, [unknown] N (of rotations N mm): the forces that they make at their node,
/// by the tangent's values. A node of stiff fabric leaves much of it, and must not make that of soft fabric count for
/// nothing. The stiffest direction counts in all three: the garment turns.
std::vector<double> round_off(const Layout& layout, const Diagonal& diagonal, const Measures& measures,
                              const double* values) {
  std::vector<double> left(layout.maps.dof->getNodeNumElements(), 0.0);
  for (size_t c = 0; c < diagonal.positions.size(); ++c) {
    double stiffest = 0.0;
    for (size_t d = 0; d < 3; ++d)
      if (layout.dof[c][d] >= 0) stiffest = std::max(stiffest, std::abs(values[diagonal.positions[c][d][d]]));
    for (const LocalId dof : layout.dof[c])
      if (dof >= 0) left[static_cast<size_t>(dof)] = rounded_position * stiffest;
  }
  for (size_t n = 0; n < diagonal.rotations.size(); ++n)
    for (size_t k = 0; k < 2; ++k)
      if (diagonal.rotations[n][k] >= 0)
        left[static_cast<size_t>(layout.rotation[n][k])] =
            rounded_position / std::sqrt(measures.mass) * std::abs(values[diagonal.rotations[n][k]]);
  return left;
}

/// Of a component of the residual, what counts.
double beyond(double residual, double round_off) {
  return std::isfinite(residual) ? std::max(0.0, std::abs(residual) - round_off) : residual;
}

/// Largest rotary over lumped inertia of a shell's node, mm^2.
double rotary_mass(const Problem& problem) {
  double largest = 0.0;
  for (const BlockModel& model : problem.models)
    if (model.is_shell()) largest = std::max(largest, model.material->thickness() * model.material->thickness() / 12.0);
  return largest;
}

}  // namespace

Equilibrium::Equilibrium(const Problem& problem, const State& start, const Held& held, const Drive& drive,
                         const SolverOptions& options, RCP<const Comm> comm, std::unique_ptr<LinearSolver> linear)
    : problem_(problem),
      options_(options),
      start_(start),
      layout_(problem, held, std::move(comm)),
      graph_(make_graph(layout_)),
      diagonal_(layout_, *graph_),
      kinematics_(problem, layout_, drive, start),
      strain_(problem, layout_, *graph_) {
  terms_.push_back(&strain_);
  const Configuration placed = kinematics_.at(*start_vector(), 0.0);
  if (ResidualStiffness::is_in(problem))
    terms_.push_back(&residual_stiffness_.emplace(problem, layout_, *graph_, strain_, placed));
  if (!problem.loads.empty()) terms_.push_back(&dead_load_.emplace(problem, layout_, kinematics_));
  if (!problem.pressures.empty()) terms_.push_back(&pressure_load_.emplace(problem, layout_, *graph_));
  terms_.push_back(&damper_.emplace(layout_, diagonal_, strain_.reference_areas()));
  if (layout_.contact) terms_.push_back(&contact_.emplace(problem, layout_, *graph_, diagonal_, kinematics_, start));
  tangent_.emplace(layout_, graph_, diagonal_, contact_ ? &contact_->projection() : nullptr,
                   ShiftMass{damper_->cluster_mass(), damper_->mass(), rotary_mass(problem)}, options.linear,
                   std::move(linear));
  if (layout_.has_shells()) adopt_thickness(placed);
  find_measures();
  damper_->start_step(placed);
}

Equilibrium::~Equilibrium() = default;

double Equilibrium::sum(double mine) const {
  double all = 0.0;
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, mine, Teuchos::outArg(all));
  return all;
}

void Equilibrium::find_measures() {
  double* values = tangent_->clear();
  Forces forces = no_forces();
  const Configuration at = kinematics_.at(*start_vector(), 0.0);
  strain_.add(at, forces, values);
  if (residual_stiffness_) residual_stiffness_->add(at, forces, values);
  if (pressure_load_) pressure_load_->add(at, forces, values);
  measures_ = measure(layout_, diagonal_, damper_->cluster_mass(), problem_.clusters.size(), values);
  if (contact_) contact_->set_stiffness(problem_.contact.relative_stiffness * std::abs(measures_.stiffness));
  tangent_->set_measures(measures_, contact_stiffness());
  round_off_ = round_off(layout_, diagonal_, measures_, values);
}

Forces Equilibrium::no_forces() const {
  Forces forces;
  forces.force.assign(3 * layout_.clusters.size(), 0.0);
  forces.magnitude = forces.force;
  if (!layout_.has_shells()) return forces;
  forces.moment.assign(2 * layout_.nodes.size(), 0.0);
  forces.moment_magnitude = forces.moment;
  return forces;
}

Forces Equilibrium::forces_of(Term* term, const Configuration& at) const {
  Forces forces = no_forces();
  if (term != nullptr) term->add(at, forces, nullptr);
  return forces;
}

Forces Equilibrium::forces_of_fabric(const Configuration& at) {
  Forces forces = forces_of(&strain_, at);
  if (residual_stiffness_) residual_stiffness_->add(at, forces, nullptr);
  return forces;
}

Evaluation Equilibrium::residual(const Vector& z, double s, Vector& f) {
  const Configuration at = kinematics_.at(z, s);
  Forces forces = no_forces();
  for (Term* term : terms_) term->add(at, forces, nullptr);
  {
    auto out = f.getDataNonConst();
    for (int c = 0; c < layout_.owned_clusters; ++c) {
      const Vec3 part =
          layout_.components_of_force(c, Eigen::Map<const Vec3>(&forces.force[3 * static_cast<size_t>(c)]));
      for (int d = 0; d < 3; ++d)
        if (layout_.dof[c][d] >= 0) out[layout_.dof[c][d]] = part[d];
    }
    for (size_t n = 0; n < layout_.rotation.size(); ++n)
      for (size_t k = 0; k < 2 && layout_.node_cluster[n] < layout_.owned_clusters; ++k)
        if (layout_.rotation[n][k] >= 0) out[layout_.rotation[n][k]] = forces.moment[2 * n + k];
    std::copy(forces.gap.begin(), forces.gap.end(),
              out.begin() + static_cast<std::ptrdiff_t>(layout_.maps.dof->getNodeNumElements()));
  }
  return evaluation(forces, f);
}

Evaluation Equilibrium::evaluation(const Forces& forces, const Vector& f) const {
  double farthest = 0.0;  // of what the forces that meet in a node would move it, over the round-off of positions
  // Squares of the residual and of its scale, gaps that are not a number; what the elements tell.
  double mine[5] = {0.0, 0.0, 0.0, forces.strain_energy, static_cast<double>(forces.extrapolated)};
  const auto data = f.getData();
  for (int c = 0; c < layout_.owned_clusters; ++c) {
    const Eigen::Map<const Vec3> magnitude(&forces.magnitude[3 * static_cast<size_t>(c)]);
    for (int d = 0; d < 3; ++d) {
      if (layout_.dof[c][d] < 0) continue;
      const double scale = layout_.is_turned(c) ? layout_.direction(c, d).cwiseProduct(magnitude).norm() : magnitude[d];
      const size_t dof = static_cast<size_t>(layout_.dof[c][d]);
      const double left = beyond(data[layout_.dof[c][d]], round_off_[dof]);
      mine[0] += left * left;
      mine[1] += scale * scale;
      if (scale > 0.0) farthest = std::max(farthest, scale / round_off_[dof]);
    }
  }
  // A moment counts as the pair of forces that it is over the distance of two nodes.
  const double lever_squared = measures_.mass;
  for (size_t n = 0; n < layout_.rotation.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    for (size_t k = 0; k < 2; ++k) {
      if (layout_.rotation[n][k] < 0) continue;
      const size_t dof = static_cast<size_t>(layout_.rotation[n][k]);
      const double moment = beyond(data[layout_.rotation[n][k]], round_off_[dof]);
      const double scale = forces.moment_magnitude[2 * n + k];
      mine[0] += moment * moment / lever_squared;
      mine[1] += scale * scale / lever_squared;
    }
  }
  double gap = 0.0;
  for (const double violation : forces.gap) {
    if (std::isnan(violation)) mine[2] += 1.0;  // a maximum over ranks would lose it
    gap = std::max(gap, std::abs(violation));
  }
  const double my_largest[2] = {gap, farthest};
  double sums[5], largest[2];
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, 5, mine, sums);
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, 2, my_largest, largest);
  Evaluation all;
  all.strain_energy = sums[3];
  all.extrapolated = static_cast<int>(sums[4]);
  const bool free_membranes = !layout_.has_shells() && problem_.loads.empty() && problem_.pressures.empty();
  const bool rests = free_membranes && largest[1] * rounded_position <= resting_distance;
  all.imbalance.force = rests && std::isfinite(sums[0]) ? 0.0 : std::sqrt(sums[0]);
  all.imbalance.force_scale = std::sqrt(sums[1]);
  all.imbalance.gap = sums[2] > 0.0 ? std::numeric_limits<double>::quiet_NaN() : largest[0];
  return all;
}

double Equilibrium::energy(const Vector& z, const Vector& held, double s) {
  Evaluation known;
  known.strain_energy = sum(strain_.potential(kinematics_.at(z, s), {}));
  return energy(known, z, held, s);
}

double Equilibrium::energy(const Evaluation& known, const Vector& z, const Vector& held, double s) {
  const Configuration at = kinematics_.at(z, s), frozen = kinematics_.at(held, s);
  double others = 0.0;
  for (Term* term : terms_)
    if (term != &strain_) others += term->potential(at, frozen);
  return known.strain_energy + sum(others);
}

void Equilibrium::linearise(const Vector& z, double s) {
  const Configuration at = kinematics_.at(z, s);
  double* values = tangent_->clear();
  Forces forces = no_forces();
  for (Term* term : terms_) term->add(at, forces, values);
  tangent_->complete();
}

bool Equilibrium::retract(Vector& z, double s) const {
  return contact_ && sum(contact_->retract(z, s) ? 1.0 : 0.0) > 0.0;
}

double Equilibrium::slope_along_surface(const Vector& f, const Vector& dz) const {
  Vector along(*dz.offsetView(layout_.maps.dof, 0)->getVector(0), Teuchos::Copy);
  if (contact_) contact_->projection().project(along);
  return f.offsetView(layout_.maps.dof, 0)->getVector(0)->dot(along);
}

void Equilibrium::end_step(const Vector& z, double s) {
  const Configuration at = kinematics_.at(z, s);
  for (Term* term : terms_) term->end_step(at);
}

void Equilibrium::start_step(const Vector& converged, double s) {
  Configuration at = kinematics_.at(converged, s);
  for (Term* term : terms_) term->start_step(at);
  tangent_->renew();
  kinematics_.start_step(at);
  if (!layout_.has_shells()) return;
  std::fill(at.rotation.begin(), at.rotation.end(), 0.0);
  adopt_thickness(at);
}

// Of shells, with the frames of the step.
void Equilibrium::adopt_thickness(const Configuration& at) {
  strain_.set_frames(kinematics_.frames());
  strain_.find_frozen(at);
  strain_.adopt_frozen();
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
  return sum(strain_.stabilisation_energy(kinematics_.at(z, s)));
}

double Equilibrium::kept_residual(const Vector& z, double s) {
  if (!residual_stiffness_) return 0.0;
  Vector f(z.getMap());
  residual_stiffness_->set_active(false);
  const Evaluation without = residual(z, s, f);
  residual_stiffness_->set_active(true);
  return without.imbalance.relative();
}

bool Equilibrium::keep_in_place(const Vector& z, double s) {
  if (residual_stiffness_) residual_stiffness_->start_step(kinematics_.at(z, s));
  return residual_stiffness_.has_value();
}

double Equilibrium::dissipation(const Vector& z, double s) const {
  return sum(damper_->dissipation(kinematics_.at(z, s)));
}

// [panel] Height over the body at which it lies, mm: that of the highest panel beneath it, and the present mean
// thickness of that one. Panels that lie beside each other are no layers.
std::vector<double> Equilibrium::heights(const std::vector<double>& thickness) const {
  const size_t panels = problem_.mesh->panels.size();
  std::vector<double> mine(2 * panels, 0.0), all(2 * panels), height(panels, 0.0);
  if (problem_.beneath.empty()) return height;
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    if (layout_.node_cluster[n] >= layout_.owned_clusters) continue;
    const int panel = problem_.mesh->panel_index(layout_.nodes[n]);
    mine[panel] += thickness[n];
    mine[panels + panel] += 1.0;
  }
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_SUM, static_cast<int>(mine.size()), mine.data(), all.data());
  for (bool higher = true; higher;) {
    const std::vector<double> before = height;
    for (size_t p = 0; p < panels; ++p)
      for (const int other : problem_.beneath[p])
        height[p] = std::max(height[p], height[other] + all[other] / all[panels + other]);
    higher = height != before;
  }
  return height;
}

// [owned cluster] Half the present thickness, and the height at which the panel lies.
std::vector<double> Equilibrium::wanted_offsets(const Configuration& at) {
  const std::vector<double> thickness = strain_.nodal_thickness(at), height = heights(thickness);
  const double own = problem_.contact.offset_by_half_thickness ? 0.5 : 0.0;
  std::vector<double> sum_of(layout_.clusters.size(), 0.0), count(layout_.clusters.size(), 0.0);
  for (size_t n = 0; n < layout_.nodes.size(); ++n) {
    sum_of[layout_.node_cluster[n]] += own * thickness[n] + height[problem_.mesh->panel_index(layout_.nodes[n])];
    count[layout_.node_cluster[n]] += 1.0;
  }
  std::vector<double> wanted;
  for (int c = 0; c < layout_.owned_clusters; ++c) wanted.push_back(sum_of[c] / count[c]);
  return wanted;
}

double Equilibrium::update_thickness(const Vector& z, double s, double tolerance) {
  const bool offsets = contact_ && (problem_.contact.offset_by_half_thickness || !problem_.beneath.empty());
  if (!offsets && !layout_.has_shells()) return 0.0;
  const Configuration at = kinematics_.at(z, s);
  std::vector<double> wanted;
  double mine = layout_.has_shells() ? strain_.find_frozen(at) : 0.0, largest = 0.0;
  if (offsets) {
    wanted = wanted_offsets(at);
    for (size_t i = 0; i < wanted.size(); ++i) mine = std::max(mine, std::abs(wanted[i] - contact_->offsets()[i]));
  }
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(largest));
  if (largest <= tolerance) return 0.0;
  if (offsets) contact_->set_offsets(wanted);
  if (layout_.has_shells()) strain_.adopt_frozen();
  tangent_->renew();
  return largest;
}

void Equilibrium::set_offsets(const std::vector<double>& offsets) {
  if (contact_) contact_->set_offsets(offsets);
}

// A node presses the body only with a force that would move it further than a gap that is none, or that counts among
// the forces of the garment: less is what rounded positions leave, and would pull unstressed fabric onto the body.
double Equilibrium::least_pressing_force(const Forces& forces) const {
  double mine = 0.0, largest = 0.0;
  for (size_t i = 0; i < 3 * static_cast<size_t>(layout_.owned_clusters); ++i)
    mine = std::max(mine, std::abs(forces.magnitude[i]));
  Teuchos::reduceAll(*layout_.comm, Teuchos::REDUCE_MAX, mine, Teuchos::outArg(largest));
  return std::max(options_.newton.gap_tolerance * std::abs(measures_.stiffness), options_.newton.tolerance * largest);
}

void Equilibrium::balance_multipliers(Vector& z, double s) {
  if (!contact_) return;
  const Configuration at = kinematics_.at(z, s);
  const Forces forces = forces_of_fabric(at);
  contact_->balance(at, forces, least_pressing_force(forces), z);
}

ForceBalance Equilibrium::balance(const Vector& z, double s) {
  const Configuration at = kinematics_.at(z, s);
  TermForces terms{forces_of_fabric(at), forces_of(dead_load_ ? &*dead_load_ : nullptr, at), forces_of(&*damper_, at),
                   forces_of(contact_ ? &*contact_ : nullptr, at), dead_load_ ? dead_load_->moments() : 0.0};
  if (pressure_load_) pressure_load_->add(at, terms.load, nullptr);
  // At rest there are only forces of round-off: they are a millionth of the least that counts.
  constexpr double least = 1e6 * resting_distance;
  return balance_of(problem_, layout_, kinematics_, at, terms, std::sqrt(measures_.mass), least * measures_.norm);
}

}  // namespace toile::solve
