#pragma once

#include <vector>

#include "terms/configuration.hpp"

namespace toile::solve {

/// What terms of the equilibrium add up to, on one rank.
struct Forces {
  std::vector<double> force;  ///< [local cluster][3] gradient of the potential, N; complete where owned
  /// [local cluster][3] sum of the magnitudes that the fabric's forces have there, N.
  std::vector<double> magnitude;
  /// The same of the rotations: [local node][2], N mm; empty without shells.
  std::vector<double> moment, moment_magnitude;
  std::vector<double> gap;     ///< [owned cluster] violation of the contact's condition, mm; empty without a body
  double strain_energy = 0.0;  ///< of the elements owned by this rank, N mm
  int extrapolated = 0;        ///< owned elements outside the calibrated range of their fabric
};

/// A part of the equilibrium: strain, a load, damping, contact. It owns what it remembers, changes that between steps
/// only, and is asked on every rank at once.
class Term {
 public:
  Term() = default;
  Term(const Term&) = delete;
  Term& operator=(const Term&) = delete;
  virtual ~Term() = default;

  /// Adds its forces at a configuration and, to `tangent` (entries of the graph; null: not wanted), their derivative.
  virtual void add(const Configuration& at, Forces& forces, double* tangent) = 0;
  /// Its potential, N mm, of this rank. What a step holds while it looks for a lower one, the multipliers of contact
  /// among it, is that of `held`; at `held` the forces are its gradient.
  virtual double potential(const Configuration& at, const Configuration& held) = 0;
  /// A step ends here that counts, and is kept in memory.
  virtual void end_step(const Configuration&) {}
  /// A step begins here.
  virtual void start_step(const Configuration&) {}
};

}  // namespace toile::solve
