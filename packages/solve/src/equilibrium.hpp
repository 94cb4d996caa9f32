#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contact_projection.hpp"
#include "element_assembly.hpp"
#include "layout.hpp"
#include "linear_solver.hpp"
#include "toile/contact/normal_contact.hpp"
#include "toile/solve/options.hpp"
#include "toile/solve/problem.hpp"
#include "toile/solve/simulation.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

class Watch;
struct EquilibriumMemory;

/// Residual of one configuration, in the measures that a step is judged by.
struct Imbalance {
  double force = 0.0;        ///< norm of the residual, N
  double force_scale = 0.0;  ///< norm of the magnitudes that meet in it, N
  double gap = 0.0;          ///< largest violation of contact, mm
  double relative() const { return force_scale > 0.0 ? force / force_scale : force; }
};

/// Discrete equilibrium of one stage: residual, tangent and energy as functions of the state vector z = (free
/// components of the clusters' positions, one contact multiplier per cluster) and of the stage's parameter s.
class Equilibrium {
 public:
  /// `linear`: of a stage before, which serves again if the graph is the same; null: there is none.
  Equilibrium(const Problem& problem, const State& start, const Held& held, const Drive& drive,
              const SolverOptions& options, RCP<const Comm> comm, std::unique_ptr<LinearSolver> linear = nullptr);

  const RCP<const Map>& map() const { return layout_.state_map; }
  RCP<Vector> start_vector() const { return vector_of(start_); }
  RCP<Vector> vector_of(const State& state) const;
  int global_contact_nodes() const;
  double contact_stiffness() const { return stiffness_; }

  /// f = (residual of the forces, N; contact complementarity, mm). NaN where a material point has no energy.
  void residual(const Vector& z, double s, Vector& f);
  /// Forms the tangent at (z, s).
  void linearise(const Vector& z, double s);
  /// Solves the tangent's system for the right-hand side b = (b_x, b_contact), the active contact conditions exactly.
  /// False: no solution.
  bool solve(const Vector& b, Vector& dz);
  /// Puts the clusters that were in contact at the last linearisation back onto the surface, along their normal.
  void retract(Vector& z, double s);
  /// y = tangent times x.
  void apply(const Vector& x, Vector& y) const;

  /// Potential of the step (strain, loads, damping, augmented contact) with the multipliers held at those of `frozen`,
  /// and about `frozen` where a follower pressure ends at an edge that is free.
  double energy(const Vector& z, const Vector& frozen, double s);

  /// Derivative of energy(z, z, s) along the part of dz that stays on the surface where the last linearisation found
  /// contact, given f at z (N mm).
  double slope_along_surface(const Vector& f, const Vector& dz) const;
  /// Sum of the magnitudes that cancel in the energy's differences, N mm.
  double energy_scale() const { return std::abs(strain_energy_); }

  Imbalance imbalance(const Vector& f) const;
  /// Norm of a difference of states without the multipliers: mm, and radians of shells.
  double distance(const Vector& dz) const { return dz.offsetView(layout_.dof_map, 0)->norm2(); }
  State state(const Vector& z, double s);
  ForceBalance balance(const Vector& z, double s);

  double strain_energy() const { return strain_energy_; }
  /// The part of it at (z, s) that only stabilises reduced elements, N mm. Collective.
  double stabilisation_energy(const Vector& z, double s);
  /// Negative pivots of the last fresh tangent before any shift (contact multipliers are not in it).
  /// -1: not known, the factorisation failed.
  int unshifted_negative_pivots() const { return unshifted_pivots_; }
  /// Elements of all ranks outside the calibrated range of their fabric, at the last residual.
  int extrapolated() const { return extrapolated_; }
  const LinearSolver& linear() const { return *linear_; }
  /// For the equations of the next stage; these ones solve no more.
  std::unique_ptr<LinearSolver> give_linear() { return std::move(linear_); }
  const Layout& layout() const { return layout_; }
  /// What follows the iterations, or null.
  void set_watch(Watch* watch) { watch_ = watch; }
  Watch* watch() const { return watch_; }
  /// The next tangent is factorised afresh.
  void renew_factorisation() { want_fresh_ = true; }

  // Damping and offsets: changed only between steps.
  /// x_n of the damping, frames of the directors, thickness of shells; the tangent will be factorised afresh.
  void start_step(const Vector& converged, double s);
  void set_damping(double coefficient) { damping_ = coefficient; }
  double damping() const { return damping_; }
  /// Off where unstable equilibria are wanted: then the tangent is taken as it is, factorised afresh every time.
  void seek_minimum(bool on) { seek_minimum_ = on; }
  /// Rate of the residual with s at fixed z, by differences of 1e-5; at the start of a stage forwards, because a
  /// support's path may have a kink there.
  void residual_rate(const Vector& z, double s, Vector& rate);
  /// Whether the path of equilibria goes on (1) or back (-1) in s at z, which it has reached by the step dz, ds.
  double path_direction(const Vector& z, double s, const Vector& dz, double ds);
  void set_first_step(double ds) { smallest_interval_ = ds; }
  double mean_tangent_diagonal() const { return mean_diagonal_; }
  double mean_mass() const { return mean_mass_; }
  double dissipation(const Vector& z, double s);  ///< c sum M* |x - x_n|^2 / dt, N mm, of the step from x_n to z
  /// Sets the contact offsets to half the present thickness, and the thickness of shells, unless none would change by
  /// more than `tolerance` (mm). Returns the largest change, 0 if they were left.
  double update_thickness(const Vector& z, double s, double tolerance);
  const std::vector<double>& offsets() const { return offset_; }
  void set_offsets(const std::vector<double>& offsets) { offset_ = offsets; }  ///< as offsets() gave them

  /// The values of a vector of unknowns, the same on every rank (checkpoint.hpp), and the vector of such values; null
  /// of none. Collective.
  std::vector<double> gather(const Vector& z) const;
  RCP<Vector> scatter(const std::vector<double>& values) const;
  /// What is remembered between steps, at the accepted z at which the next one begins. Collective.
  EquilibriumMemory memory(const Vector& z) const;
  /// Remembers that again, in equations that were set up from the same start. Returns z. Collective.
  RCP<Vector> resume(const EquilibriumMemory& memory);

  /// Multipliers that balance the present strain forces at touching nodes, which are put onto the surface if they
  /// press it. Collective.
  void balance_multipliers(Vector& z, double s);

 private:
  void positions(const Vector& z, double s);
  void set_position(int cluster, const double* z, double s);
  Vec3 cluster_position(size_t c) const;
  double held_position(int cluster, int component, double s) const;
  std::array<double, 2> held_rotation(size_t node, double s) const;
  double torque_of_director(const ElementAssembly::Sums& sums, size_t node, double s) const;
  /// Length of a vector's part in the free components of a cluster.
  double length_of_free_part(int cluster, const Vec3& direction) const;
  /// The same of the body's normal at the last linearisation, of a cluster in contact.
  double free_part(size_t cluster) const { return free_part_[cluster]; }
  Vec3 separation(int node, int cluster, double s) const;
  contact::NodeContact contact(int cluster, double s, double multiplier) const;
  void find_open_seams();
  void retract_cluster(size_t cluster, double s, double* z);
  size_t multipliers() const { return layout_.contact ? static_cast<size_t>(layout_.owned_clusters) : 0; }
  void find_diagonal_blocks();
  void find_loads();
  void find_frames();
  std::int64_t place(LocalId row, LocalId column) const;
  Vec3 moment_axis(size_t node, int k) const;
  double load_potential(const ElementAssembly::Sums& sums, double s) const;
  void add_shift(double factor, double* values) const;
  std::vector<double> wanted_offsets();
  double least_pressing_force(const ElementAssembly::Sums& sums) const;
  void add_directors(State& state) const;
  double moment_magnitudes(const ElementAssembly::Sums& sums, double s) const;
  void scale();
  std::vector<double> damping_force(double s) const;
  void add_contact_tangent(const Vector& z, double s, double* values);
  void add_to_diagonal(double factor, double* values) const;
  double interval(double s) const;
  void factorise_positive();
  double sum(double mine) const;

  const Problem& problem_;
  const SolverOptions options_;
  Drive drive_;
  Layout layout_;
  RCP<const Graph> graph_;
  RCP<Matrix> tangent_;    ///< of the potential with the multipliers held, without contact's stiffness
  RCP<Matrix> projected_;  ///< on the surface in contact: what is factorised
  ContactProjection projection_;
  ElementAssembly elements_;
  std::unique_ptr<LinearSolver> linear_;
  std::vector<std::array<std::array<std::int64_t, 3>, 3>> diagonal_;  ///< [owned cluster] places in the tangent or -1
  std::vector<double> cluster_mass_;                                  ///< [local cluster] mm^2

  std::vector<double> y_;                 ///< [local cluster][3] position of the master at the last evaluation
  Configuration at_;                      ///< at the last evaluation
  std::vector<double> magnitude_;         ///< [local cluster][3] N
  std::vector<double> moment_magnitude_;  ///< [local node][2] N mm; empty without shells
  std::vector<double> mass_;              ///< [local node] reference area, mm^2
  std::vector<double> load_;              ///< [local cluster][3] dead load at load 1, N
  std::vector<Vec3> moment_;              ///< [local node] dead moment at load 1, N mm; empty without shells
  std::vector<Frame> frames_;  ///< [local node] of the directors at the start of the step; empty without shells
  std::vector<double> rotation_previous_;                       ///< [local node][2] theta that belongs to them
  std::vector<std::array<std::int64_t, 2>> rotation_diagonal_;  ///< [local node] places in the tangent or -1
  double rotary_ = 0.0;                                         ///< rotary over lumped inertia of a shell's node, mm^2
  std::vector<double> x_previous_;                              ///< [local node][3]
  double s_previous_ = 0.0;
  double smallest_interval_ = 0.1;
  double damping_ = 0.0;
  State start_;
  std::vector<double> offset_;  ///< [owned cluster] mm
  double stiffness_ = 0.0;      ///< augmentation of contact, N/mm
  double mean_diagonal_ = 0.0;
  double mean_mass_ = 0.0;      ///< mm^2; its root is the lever that makes moments comparable to forces
  double diagonal_norm_ = 0.0;  ///< of the start's tangent over all free unknowns, N/mm
  double strain_energy_ = 0.0;
  int unshifted_pivots_ = -1;
  double last_shift_ = 0.0;
  int extrapolated_ = 0;
  Watch* watch_ = nullptr;
  bool want_fresh_ = true;
  bool seek_minimum_ = true;
  std::vector<double> free_part_;      ///< [owned cluster]
  std::vector<Vec3> mean_separation_;  ///< [owned cluster] of the placed nodes from their master, mm
  std::vector<double> placed_depth_;   ///< [owned cluster] depth of that mean inside the body when placed, mm <= 0
};

}  // namespace toile::solve
