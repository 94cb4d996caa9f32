#pragma once

#include <functional>
#include <vector>

#include "toile/identify/problem.hpp"
#include "toile/identify/residuals.hpp"
#include "toile/identify/spec.hpp"

namespace toile::identify {

/// Called with the generations done and the smallest chi^2 so far.
using SearchProgress = std::function<void(int, double)>;

/// Best valid candidate of a global search (pagmo) with `seed`.
std::vector<double> search(const FitProblem& problem, Residuals& residuals, const Algorithm& algorithm, unsigned seed,
                           const SearchProgress& progress);

}  // namespace toile::identify
