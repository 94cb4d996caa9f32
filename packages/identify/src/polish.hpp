#pragma once

#include <functional>
#include <vector>

#include "toile/identify/problem.hpp"
#include "toile/identify/residuals.hpp"

namespace toile::identify {

/// Smallest chi^2 near `x` by sequential quadratic programming (SLSQP; Kraft 1994) with the law's derivatives, within
/// the bounds, the conditions and, if asked for, with rising stresses. Returns a valid candidate that is no worse than
/// `x`. `progress` is called with the smallest chi^2 so far after every candidate of which the derivatives were
/// evaluated.
std::vector<double> polished(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x,
                             const std::function<void(double)>& progress);

}  // namespace toile::identify
