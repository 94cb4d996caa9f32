#pragma once

#include <string>

#include "toile/identify/statistics.hpp"

namespace toile::identify {

/// The fitted material as an entry of the list Materials of a scene, ready to be pasted; reads back to the last bit.
/// `limits`: what its runs must know; what is empty or 0 is not written.
std::string material_xml(const FitProblem& problem, const std::vector<double>& params,
                         const material::FitLimits& limits = {});

/// The same with what adds its law, if it is not built in: a file in `folder` that a scene can include. `fit` is the
/// list that `problem` was read from.
std::string include_xml(const FitProblem& problem, const std::vector<double>& params, const base::List& fit,
                        const std::string& folder, const material::FitLimits& limits = {});

/// What a user should know of a fit: starts, curves, parameters with their deviations and correlations, and what limits
/// the trust in it.
std::string report_text(const FitProblem& problem, const FitResult& result, const std::vector<CurveReport>& curves,
                        const ParameterStatistics& statistics);

}  // namespace toile::identify
