#pragma once

#include <functional>
#include <vector>

#include "toile/identify/problem.hpp"
#include "toile/identify/spec.hpp"

namespace toile::identify {

/// One search with its polish.
struct Start {
  unsigned seed;
  double searched, polished;  ///< chi^2 after each
  std::vector<double> x;
};

struct FitResult {
  std::vector<Start> starts;
  std::size_t best = 0;        ///< of the starts
  std::vector<double> params;  ///< [n_params] of the best one
  double chi_squared = 0.0;

  const std::vector<double>& x() const { return starts[best].x; }
};

/// Called with the part of the work that is done (0..1) and the smallest chi^2 of the current start.
using FitProgress = std::function<void(double, double)>;

/// Runs every start. The same problem and seed give the same result, to the last bit.
FitResult fit(const FitProblem& problem, const Algorithm& algorithm, const FitProgress& progress);

}  // namespace toile::identify
