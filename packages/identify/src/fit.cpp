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

/// The first stretch of a fitted curve, in their order, of which `is_wanted`(stresses of the curve, index) tells:
/// "curve \"wale\" at stretch 1.5"; empty if there is none.
template <class Condition>
std::string first_place(const FitProblem& problem, const std::vector<double>& params, const Condition& is_wanted) {
  for (const Curve& curve : problem.curves()) {
    if (curve.weight == 0.0) continue;
    std::vector<double> stress(curve.stretch.size());
    forward_model({curve})->stress(problem.law(), params.data(), stress.data());
    for (std::size_t i = 0; i < stress.size(); ++i) {
      if (!is_wanted(stress, i)) continue;
      std::ostringstream text;
      text << "curve \"" << curve.name << "\" at stretch " << curve.stretch[i];
      return text.str();
    }
  }
  return "";
}

std::string missing_state(const FitProblem& problem, const std::vector<double>& params) {
  return first_place(problem, params, [](const auto& stress, std::size_t i) { return !std::isfinite(stress[i]); });
}

std::string falling_stress(const FitProblem& problem, const std::vector<double>& params) {
  return first_place(problem, params,
                     [](const auto& stress, std::size_t i) { return i > 0 && stress[i] < stress[i - 1]; });
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
                      "the fit has no result: no start ended at parameters for which every fitted point has a state "
                      "(there is none for " +
                          missing_state(problem, result.params) +
                          "); other bounds, more generations or starts, or shorter curves may help");
  if (problem.keeps_rising()) result.falls = falling_stress(problem, result.params);
  return result;
}

}  // namespace toile::identify
