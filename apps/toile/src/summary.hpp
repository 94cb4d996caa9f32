#pragma once

#include <string>
#include <vector>

#include "toile/base/timer.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/fields.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::app {

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

/// What limits the trust in the last state: fabric outside its calibrated range, contact off the smooth surface.
std::vector<std::string> field_warnings(const scene::Scene& scene, const solve::Fields& fields,
                                        const solve::StepReport& report);

/// The summary that ends a run.
std::string summary(const scene::Scene& scene, const solve::Fields& fields, const solve::StepReport& report,
                    const solve::SolveStatistics& statistics, const base::Timer& timer);

}  // namespace toile::app
