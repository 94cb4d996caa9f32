#pragma once

#include "toile/solve/fields.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::run {

/// What equilibria leave as round-off, of the largest stress or of all forces.
inline constexpr double noise = 1e-8;

/// Figures of a finished run by which it is judged and checked.
struct Figures {
  double largest_pressure = 0.0;   ///< kPa
  double smallest_pressure = 0.0;  ///< kPa, among nodes in contact
  double smallest_stress = 0.0;    ///< smallest principal Cauchy stress, kPa; 0 if it is round-off
  double force_balance = 0.0;      ///< residual of all forces over the sum of their magnitudes
  double largest_gap = 0.0;        ///< mm
  double dissipation_ratio = 0.0;
  double extrapolated = 0.0;  ///< number of elements
};

/// `report`: of the last accepted step. The contact part of the balance is taken from the written fields.
Figures figures_of(const solve::Fields& fields, const solve::StepReport& report);

}  // namespace toile::run
