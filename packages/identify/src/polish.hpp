#pragma once

#include <vector>

#include "toile/identify/problem.hpp"
#include "toile/identify/residuals.hpp"

namespace toile::identify {

/// Smallest chi^2 near `x` by sequential quadratic programming (SLSQP; Kraft 1994) with the law's derivatives, within
/// the bounds, the conditions and, if asked for, with rising stresses. Returns a valid candidate that is no worse than
/// `x`.
std::vector<double> polished(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x);

}  // namespace toile::identify
