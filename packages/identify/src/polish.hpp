#pragma once

#include <functional>
#include <vector>

#include "toile/identify/problem.hpp"
#include "toile/identify/residuals.hpp"

namespace toile::identify {

/// Smallest chi^2 near `x` by damped Gauss-Newton steps (Levenberg 1944, Marquardt 1963) with the law's derivatives,
/// each the exact minimum of the linear model within the bounds, the conditions and, if asked for, rising stresses (see
/// nearest_point). Returns a valid candidate that is no worse than `x`.
/// `progress` is called with the smallest chi^2 so far after every step.
std::vector<double> polished(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x,
                             const std::function<void(double)>& progress);

}  // namespace toile::identify
