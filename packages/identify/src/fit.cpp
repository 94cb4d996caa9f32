#include "toile/identify/fit.hpp"

#include <algorithm>

#include "polish.hpp"
#include "search.hpp"

namespace toile::identify {
namespace {

/// A start with homogeneous states in the place of clamped strips.
Start homogeneous_start(const FitProblem& problem, Residuals& residuals, const Algorithm& algorithm, int number,
                        const FitProgress& progress) {
  const std::string phase = std::string(algorithm.polish ? "search and polish" : "search") +
                            (problem.fits_strips() ? " with homogeneous states" : "");
  const unsigned seed = algorithm.seed + static_cast<unsigned>(number);
  const auto report = [&](int generation, double chi) {
    progress({phase, (number + static_cast<double>(generation) / algorithm.generations) / algorithm.starts, chi});
  };
  Start start = {seed, 0.0, 0.0, search(problem, residuals, algorithm, seed, report)};
  start.searched = residuals.chi_squared(start.x);
  if (algorithm.polish) start.x = polished(problem, residuals, start.x, [](double) {});
  start.polished = residuals.chi_squared(start.x);
  progress({phase, (number + 1.0) / algorithm.starts, start.polished});
  return start;
}

void polish_with_strips(const FitProblem& problem, Residuals& residuals, Start& start, const FitProgress& progress) {
  // What a polish usually needs; where it takes longer, a fifth is always thought to be left.
  const double usual = 20.0 + 4.0 * static_cast<double>(problem.free().size());
  int evaluations = 0;
  const auto report = [&](double chi) {
    ++evaluations;
    progress({"polish with clamped strips", evaluations / std::max(usual, 1.25 * evaluations), chi});
  };
  start.strips = {residuals.chi_squared(start.x), 0.0};
  start.x = polished(problem, residuals, start.x, report);
  start.strips->after = residuals.chi_squared(start.x);
  progress({"polish with clamped strips", 1.0, start.strips->after});
}

}  // namespace

FitResult fit(const FitProblem& problem, const Algorithm& algorithm, const FitProgress& progress) {
  Residuals homogeneous(problem, Fidelity::homogeneous);
  FitResult result;
  for (int s = 0; s < algorithm.starts; ++s) {
    result.starts.push_back(homogeneous_start(problem, homogeneous, algorithm, s, progress));
    if (result.starts[s].polished < result.starts[result.best].polished) result.best = static_cast<std::size_t>(s);
  }
  Start& best = result.starts[result.best];
  if (problem.fits_strips()) {
    Residuals residuals(problem);
    if (algorithm.polish) polish_with_strips(problem, residuals, best, progress);
    result.chi_squared = residuals.chi_squared(best.x);
  } else {
    result.chi_squared = best.polished;
  }
  result.params = problem.params(result.x());
  return result;
}

}  // namespace toile::identify
