#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "equilibrium/kinematics.hpp"
#include "equilibrium/reactions.hpp"
#include "equilibrium/tangent.hpp"
#include "terms/body_contact.hpp"
#include "terms/damper.hpp"
#include "terms/dead_load.hpp"
#include "terms/evaluation.hpp"
#include "terms/pressure_load.hpp"
#include "terms/residual_stiffness.hpp"
#include "terms/strain.hpp"
#include "toile/solve/options.hpp"

namespace toile::solve {

class Watch;
struct EquilibriumMemory;

/// Discrete equilibrium of one stage: residual, tangent and energy as functions of the state vector z = (free
/// components of the clusters' positions, one contact multiplier per cluster) and of the stage's parameter s, summed
/// over its terms.
class Equilibrium {
 public:
  /// `linear`: of a stage before, which serves again if the graph is the same; null: there is none.
  Equilibrium(const Problem& problem, const State& start, const Held& held, const Drive& drive,
              const SolverOptions& options, RCP<const Comm> comm, std::unique_ptr<LinearSolver> linear = nullptr);
  Equilibrium(const Equilibrium&) = delete;
  Equilibrium& operator=(const Equilibrium&) = delete;
  ~Equilibrium();

  const RCP<const Map>& map() const { return layout_.maps.state; }
  const Layout& layout() const { return layout_; }
  RCP<Vector> start_vector() const;
  int global_contact_nodes() const;
  double contact_stiffness() const { return contact_ ? contact_->stiffness() : 0.0; }
  const Measures& measures() const { return measures_; }

  /// f = (residual of the forces, N; contact complementarity, mm). NaN where a material point has no energy.
  Evaluation residual(const Vector& z, double s, Vector& f);
  /// Forms the tangent at (z, s).
  void linearise(const Vector& z, double s);
  /// Solves the tangent's system for the right-hand side b = (b_x, b_contact), the active contact conditions exactly.
  /// False: no solution.
  bool solve(const Vector& b, Vector& dz) { return tangent_->solve(b, dz); }
  /// y = tangent times x.
  void apply(const Vector& x, Vector& y) const { tangent_->apply(x, y); }
  /// Of the last tangent. Its settings change between steps only.
  Tangent& tangent() { return *tangent_; }
  const Tangent& tangent() const { return *tangent_; }
  /// Puts the clusters that were in contact at the last linearisation back onto the surface, along their normal. False:
  /// there are none, on any rank. Collective.
  bool retract(Vector& z, double s) const;

  /// Potential of the step (strain, loads, damping, augmented contact), N mm; what a step holds (the multipliers, free
  /// edges under pressure) is that of `held`.
  double energy(const Vector& z, const Vector& held, double s);
  /// The same where `known` was evaluated, at z: strain is not evaluated again.
  double energy(const Evaluation& known, const Vector& z, const Vector& held, double s);
  /// Derivative of energy(z, z, s) along the part of dz that stays on the surface where the last linearisation found
  /// contact, given f at z (N mm).
  double slope_along_surface(const Vector& f, const Vector& dz) const;

  /// Norm of a difference of states without the multipliers: mm, and radians of shells.
  double distance(const Vector& dz) const { return dz.offsetView(layout_.maps.dof, 0)->norm2(); }
  State state(const Vector& z, double s) const;
  ForceBalance balance(const Vector& z, double s);
  /// The part of the strain energy at (z, s) that only stabilises reduced elements, N mm. Collective.
  double stabilisation_energy(const Vector& z, double s);
  /// The relative residual that the residual stiffness carries. Collective.
  double kept_residual(const Vector& z, double s);
  double dissipation(const Vector& z, double s) const;  ///< c sum M |x - x_n|^2 / dt, N mm, of the step from x_n to z
  /// Rate of the residual with s at fixed z, by differences of 1e-5; at the start of a stage forwards, because a
  /// support's path may have a kink there.
  void residual_rate(const Vector& z, double s, Vector& rate);
  /// Whether the path of equilibria goes on (1) or back (-1) in s at z, which it has reached by the step dz, ds.
  double path_direction(const Vector& z, double s, const Vector& dz, double ds);

  /// What follows the iterations, or null.
  void set_watch(Watch* watch) { watch_ = watch; }
  Watch* watch() const { return watch_; }

  // Damping and offsets: changed only between steps.
  /// A step that counts ends here: contact keeps it in memory.
  void end_step(const Vector& z, double s);
  /// x_n of the damping and of contact, frames of the directors, thickness of shells; the tangent will be factorised
  /// afresh.
  void start_step(const Vector& converged, double s);
  /// Residual stiffness counts from z on. False: there is none.
  bool keep_in_place(const Vector& z, double s);
  void set_damping(double coefficient) { damper_->set_coefficient(coefficient); }
  double damping() const { return damper_->coefficient(); }
  void set_first_step(double ds) { damper_->set_first_step(ds); }
  /// Sets the contact offsets to the present thickness, and the thickness of shells, unless none would change by
  /// more than `tolerance` (mm). Returns the largest change, 0 if they were left.
  double update_thickness(const Vector& z, double s, double tolerance);
  std::vector<double> offsets() const { return contact_ ? contact_->offsets() : std::vector<double>(); }
  void set_offsets(const std::vector<double>& offsets);  ///< as offsets() gave them
  /// Multipliers that balance the present forces at touching nodes, which are put onto the surface if they press it.
  /// Collective.
  void balance_multipliers(Vector& z, double s);

  /// The values of a vector of unknowns, the same on every rank (checkpoint.hpp), and the vector of such values; null
  /// of none. Collective.
  std::vector<double> gather(const Vector& z) const;
  RCP<Vector> scatter(const std::vector<double>& values) const;
  /// What is remembered between steps, at the accepted z at which the next one begins. Collective.
  EquilibriumMemory memory(const Vector& z) const;
  /// Remembers that again, in equations that were set up from the same start. Returns z. Collective.
  RCP<Vector> resume(const EquilibriumMemory& memory);

 private:
  Forces no_forces() const;
  Forces forces_of(Term* term, const Configuration& at) const;
  Forces forces_of_fabric(const Configuration& at);
  Evaluation evaluation(const Forces& forces, const Vector& f) const;
  void find_measures();
  void adopt_thickness(const Configuration& at);
  std::vector<double> heights(const std::vector<double>& thickness) const;
  std::vector<double> wanted_offsets(const Configuration& at);
  void add_contact(EquilibriumMemory& memory) const;
  double least_pressing_force(const Forces& forces) const;
  double sum(double mine) const;

  const Problem& problem_;
  const SolverOptions options_;
  const State start_;
  Layout layout_;
  RCP<const Graph> graph_;
  Diagonal diagonal_;
  Kinematics kinematics_;
  Strain strain_;
  std::optional<ResidualStiffness> residual_stiffness_;
  std::optional<DeadLoad> dead_load_;
  std::optional<PressureLoad> pressure_load_;
  std::optional<Damper> damper_;
  std::optional<BodyContact> contact_;
  std::vector<Term*> terms_;  ///< those that the scene has
  std::optional<Tangent> tangent_;
  Measures measures_;
  std::vector<double> round_off_;  ///< [owned unknown] what rounded positions leave of a balance, N (of rotations N mm)
  Watch* watch_ = nullptr;
};

}  // namespace toile::solve
