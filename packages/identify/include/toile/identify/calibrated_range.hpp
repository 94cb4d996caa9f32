#pragma once

#include <string>
#include <vector>

#include "toile/identify/statistics.hpp"

namespace toile::identify {

/// What the fitted curves (weight above 0) say of a fabric's range.
struct CalibratedRange {
  double largest_wale = 1.0, largest_course = 1.0;  ///< largest fibre stretches of the data's homogeneous states
  /// Whether the law is the same along both at every one of these states, so that each stretch tests both directions.
  bool tests_both = false;
  std::vector<double> params;  ///< [n_params] of the fit, with "calibrated strain" from the data if the law has it
  bool is_set = false;         ///< whether it was set
};

/// Ends the calibrated range of a fitted law where its data end: "calibrated strain" becomes the least one, rounded up
/// to 1e-4, with which no fitted point is outside of the range. The law is then the fitted one at every point, and a
/// run tells where it goes beyond. A value that the fit file gives, or that is free, stays; so does one that the data
/// exceed.
CalibratedRange calibrated_range(const FitProblem& problem, const std::vector<double>& params);

/// What a run with the fitted fabric must know. Fabric at rest counts as tested.
material::FitLimits fit_limits(const FitProblem& problem, const ParameterStatistics& statistics,
                               const CalibratedRange& range);

/// One paragraph for the report.
std::string range_text(const CalibratedRange& range);

}  // namespace toile::identify
