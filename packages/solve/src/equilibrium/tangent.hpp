#pragma once

#include <memory>
#include <vector>

#include "equilibrium/contact_projection.hpp"
#include "equilibrium/diagonal.hpp"
#include "linear/linear_solver.hpp"
#include "toile/solve/options.hpp"

namespace toile::solve {

/// Means of the undamped start tangent and of the lumped area: the measures of contact stiffness, damping and shifts. A
/// rotation counts as the displacement that it makes at the distance of two nodes; the means are of displacements where
/// there are free ones. The same on every rank.
struct Measures {
  double stiffness = 0.0;  ///< mean diagonal entry, N/mm
  double mass = 0.0;       ///< mean lumped area, mm^2; its root is the lever that makes moments comparable to forces
  double norm = 0.0;       ///< of the diagonal over all free unknowns, N/mm
};

/// `values`: of the tangent; `mass` [local cluster] mm^2; `clusters`: of the garment. Collective.
Measures measure(const Layout& layout, const Diagonal& diagonal, const std::vector<double>& mass, size_t clusters,
                 const double* values);

/// What a multiple is added of to a tangent that is not positive definite.
struct ShiftMass {
  const std::vector<double>& cluster;  ///< [local cluster] mm^2
  const std::vector<double>& node;     ///< [local node] mm^2
  double rotary = 0.0;                 ///< rotary over lumped inertia of a shell's node, mm^2
};

/// Derivative of the residual with the contact multipliers held, and the solution of its system with the active contact
/// conditions.
class Tangent {
 public:
  /// `contact`: null without a body. `linear`: of a stage before, which serves again if the graph is the same, or null.
  Tangent(const Layout& layout, const RCP<const Graph>& graph, const Diagonal& diagonal,
          const ContactProjection* contact, const ShiftMass& mass, const LinearOptions& options,
          std::unique_ptr<LinearSolver> linear);
  /// `augmentation` of contact, N/mm. Before the first linear system.
  void set_measures(const Measures& measures, double augmentation);

  /// Its entries, all zero, for the terms to add to.
  double* clear();
  /// The entries are complete: factorises what is to be solved.
  void complete();
  /// dz = solution for b = (b_x, b_contact); false: there is none.
  bool solve(const Vector& b, Vector& dz);
  /// y = tangent times x, contact conditions included.
  void apply(const Vector& x, Vector& y) const;

  /// The direction of the unknowns without multipliers in which the last one resists least, also where it had to be
  /// shifted; null: the linear solver does not find it. |x| = 1. Collective.
  RCP<Vector> softest() { return linear_->softest(); }
  /// Condition number of the last one in its unknowns (N, mm, radians), where it was not shifted: the largest over the
  /// smallest magnitude of its eigenvalues, each within a few per cent. 0: the options do not ask for it, or
  /// it is not known. Collective.
  double condition();
  /// x.Kx / x.x of the last one before any shift, N/mm. Collective.
  double stiffness_along(const Vector& x) const;

  /// The next one is factorised afresh.
  void renew() { want_fresh_ = true; }
  /// Off where unstable equilibria are wanted: then it is taken as it is, factorised afresh every time.
  void seek_minimum(bool on) { seek_minimum_ = on; }
  /// Negative pivots of the last fresh one before any shift (contact multipliers are not in it). -1: not known, the
  /// factorisation failed.
  int unshifted_negative_pivots() const { return unshifted_pivots_; }
  double last_shift() const { return last_shift_; }
  void set_last_shift(double shift) { last_shift_ = shift; }

  const LinearSolver& linear() const { return *linear_; }
  std::unique_ptr<LinearSolver> give_linear() { return std::move(linear_); }

 private:
  size_t conditions() const { return contact_ == nullptr ? 0 : static_cast<size_t>(layout_.owned_clusters); }
  void add_shift(double factor, double* values) const;
  void factorise_positive();

  const Layout& layout_;
  const Diagonal& diagonal_;
  const ContactProjection* contact_;
  ShiftMass mass_;
  RCP<Matrix> matrix_;     ///< without contact's conditions
  RCP<Matrix> projected_;  ///< on the surface in contact: what is factorised
  std::unique_ptr<LinearSolver> linear_;
  Measures measures_;
  double augmentation_ = 0.0;
  int unshifted_pivots_ = -1;
  double last_shift_ = 0.0;
  bool condition_is_wanted_ = false;
  bool want_fresh_ = true, seek_minimum_ = true;
};

}  // namespace toile::solve
