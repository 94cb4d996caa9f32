#pragma once

#include <vector>

#include "equilibrium/diagonal.hpp"
#include "terms/term.hpp"

namespace toile::solve {

/// Artificial damping: c M (x - x_n)/dt against the nodes' motion since the start of the step, with M the reference
/// area that belongs to a node and dt the interval of s (doc/theory.md, "Damping").
class Damper : public Term {
 public:
  /// `mass` [local node] mm^2.
  Damper(const Layout& layout, const Diagonal& diagonal, std::vector<double> mass);

  void add(const Configuration& at, Forces& forces, double* tangent) override;
  double potential(const Configuration& at, const Configuration& held) override;
  void start_step(const Configuration& at) override;

  void set_coefficient(double c) { coefficient_ = c; }
  double coefficient() const { return coefficient_; }
  /// Interval that a step at the parameter of its start counts as.
  void set_first_step(double ds) { smallest_interval_ = ds; }
  /// c sum M |x - x_n|^2 / dt of this rank, N mm.
  double dissipation(const Configuration& at) const;

  const std::vector<double>& cluster_mass() const { return cluster_mass_; }  ///< [local cluster] mm^2
  const std::vector<double>& mass() const { return mass_; }                  ///< [local node] mm^2

 private:
  double interval(double s) const { return s > step_start_ ? s - step_start_ : smallest_interval_; }

  const Layout& layout_;
  const Diagonal& diagonal_;
  std::vector<double> mass_, cluster_mass_;
  std::vector<double> start_;  ///< [local node][3] x_n
  double step_start_ = 0.0;    ///< s there
  double smallest_interval_ = 0.1;
  double coefficient_ = 0.0;
};

}  // namespace toile::solve
