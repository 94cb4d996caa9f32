#include "toile/identify/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "polish.hpp"
#include "search.hpp"
#include "toile/base/error.hpp"
#include "toile/identify/curve_models.hpp"

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
  Start start = {seed, 0.0, 0.0, 0.0, search(problem, residuals, algorithm, seed, report)};
  start.searched = residuals.chi_squared(start.x);
  if (algorithm.polish) start.x = polished(problem, residuals, start.x, [](double) {});
  start.polished = residuals.chi_squared(start.x);
  start.merit = residuals.merit();
  progress({phase, (number + 1.0) / algorithm.starts, start.polished});
  return start;
}

/// False if some strip has no state there.
bool polish_with_strips(const FitProblem& problem, Residuals& residuals, Start& start, const FitProgress& progress) {
  // What a polish usually needs; where it takes longer, a fifth is always thought to be left.
  const double usual = 20.0 + 4.0 * static_cast<double>(problem.free().size());
  int evaluations = 0;
  const auto report = [&](double chi) {
    ++evaluations;
    progress({"polish with clamped strips", evaluations / std::max(usual, 1.25 * evaluations), chi});
  };
  start.strips = {residuals.chi_squared(start.x), Residuals::hopeless};
  if (start.strips->before >= Residuals::hopeless) return false;
  start.x = polished(problem, residuals, start.x, report);
  start.strips->after = residuals.chi_squared(start.x);
  progress({"polish with clamped strips", 1.0, start.strips->after});
  return true;
}

/// "curve \"wale\" from stretch 1.5 on": the first fitted curve that has no state at some point.
std::string missing_states(const FitProblem& problem, const std::vector<double>& params) {
  for (const Curve& curve : problem.curves()) {
    std::vector<double> stress(curve.stretch.size());
    if (curve.weight == 0.0 || forward_model({curve})->stress(problem.law(), params.data(), stress.data()) == 0)
      continue;
    for (std::size_t i = 0; i < stress.size(); ++i)
      if (!std::isfinite(stress[i])) {
        std::ostringstream text;
        text << "curve \"" << curve.name << "\" has none at stretch " << curve.stretch[i];
        return text.str();
      }
  }
  return "";
}

/// Where the stress of a fitted curve falls.
std::string falling_stress(const FitProblem& problem, const std::vector<double>& params) {
  for (const Curve& curve : problem.curves()) {
    std::vector<double> stress(curve.stretch.size());
    if (curve.weight == 0.0) continue;
    forward_model({curve})->stress(problem.law(), params.data(), stress.data());
    for (std::size_t i = 1; i < stress.size(); ++i)
      if (stress[i] < stress[i - 1]) {
        std::ostringstream text;
        text << "curve \"" << curve.name << "\" falls from stretch " << curve.stretch[i - 1] << " to "
             << curve.stretch[i];
        return text.str();
      }
  }
  return "";
}

}  // namespace

FitResult fit(const FitProblem& problem, const Algorithm& algorithm, const FitProgress& progress) {
  Residuals homogeneous(problem, Fidelity::homogeneous);
  FitResult result;
  for (int s = 0; s < algorithm.starts; ++s)
    result.starts.push_back(homogeneous_start(problem, homogeneous, algorithm, s, progress));
  std::vector<std::size_t> order(result.starts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return result.starts[a].merit < result.starts[b].merit; });
  result.best = order.front();
  result.chi_squared = result.starts[result.best].polished;
  if (problem.fits_strips()) {
    Residuals residuals(problem);
    // A law that homogeneous states fit best may let a strip buckle.
    for (const std::size_t s : order) {
      Start& start = result.starts[s];
      const bool has_states = algorithm.polish ? polish_with_strips(problem, residuals, start, progress)
                                               : residuals.chi_squared(start.x) < Residuals::hopeless;
      result.best = s;
      if (has_states) break;
    }
    result.chi_squared = residuals.chi_squared(result.x());
  }
  result.params = problem.params(result.x());
  if (result.chi_squared >= Residuals::hopeless)
    throw base::Error(base::ExitCode::solve_failed,
                      "the fit has no result: no start ended at parameters for which every fitted point has a state (" +
                          missing_states(problem, result.params) +
                          "); other bounds, more generations or starts, or shorter curves may help");
  if (problem.keeps_rising()) result.falls = falling_stress(problem, result.params);
  return result;
}

}  // namespace toile::identify
