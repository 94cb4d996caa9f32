#include "toile/identify/fit.hpp"

#include "polish.hpp"
#include "search.hpp"

namespace toile::identify {

FitResult fit(const FitProblem& problem, const Algorithm& algorithm, const FitProgress& progress) {
  Residuals residuals(problem);
  FitResult result;
  for (int s = 0; s < algorithm.starts; ++s) {
    const unsigned seed = algorithm.seed + static_cast<unsigned>(s);
    const auto report = [&](int generation, double chi) {
      progress((s + static_cast<double>(generation) / algorithm.generations) / algorithm.starts, chi);
    };
    Start start = {seed, 0.0, 0.0, search(problem, residuals, algorithm, seed, report)};
    start.searched = residuals.chi_squared(start.x);
    if (algorithm.polish) start.x = polished(problem, residuals, start.x);
    start.polished = residuals.chi_squared(start.x);
    progress((s + 1.0) / algorithm.starts, start.polished);
    result.starts.push_back(start);
    if (start.polished < result.starts[result.best].polished) result.best = result.starts.size() - 1;
  }
  result.params = problem.params(result.x());
  result.chi_squared = result.starts[result.best].polished;
  return result;
}

}  // namespace toile::identify
