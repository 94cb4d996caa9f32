#pragma once

namespace toile::solve {

/// Residual of one configuration, in the measures that a step is judged by.
struct Imbalance {
  double force = 0.0;        ///< norm of the residual beyond round-off, N
  double force_scale = 0.0;  ///< norm of the magnitudes that meet in it, N
  double gap = 0.0;          ///< largest violation of contact, mm
  double relative() const { return force_scale > 0.0 ? force / force_scale : force; }
};

/// What is known of one configuration beside its residual; the same on every rank.
struct Evaluation {
  Imbalance imbalance;
  double strain_energy = 0.0;  ///< N mm
  int extrapolated = 0;        ///< elements outside the calibrated range of their fabric
};

}  // namespace toile::solve
