#include "search.hpp"

#include <algorithm>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>

namespace toile::identify {
namespace {

/// Generations between two reports.
constexpr unsigned stride = 10;

/// The problem as pagmo wants it. Every candidate is repaired first, so that conditions need no penalty.
struct UserProblem {
  const FitProblem* problem = nullptr;
  Residuals* residuals = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    residuals->chi_squared(problem->repaired(x));
    return {residuals->merit()};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const std::size_t n = problem == nullptr ? 1 : problem->free().size();
    return {pagmo::vector_double(n, 0.0), pagmo::vector_double(n, 1.0)};
  }
};

pagmo::algorithm algorithm_of(const Algorithm& settings, unsigned generations, unsigned seed) {
  if (settings.genetic)
    return pagmo::algorithm(pagmo::sga(generations, 0.9, 10.0, 0.1, 20.0, 2, "sbx", "polynomial", "tournament", seed));
  // No early end by a flat population: every start has its generations.
  return pagmo::algorithm(pagmo::sade(generations, 2, 1, 0.0, 0.0, true, seed));
}

}  // namespace

std::vector<double> search(const FitProblem& problem, Residuals& residuals, const Algorithm& settings, unsigned seed,
                           const SearchProgress& progress) {
  pagmo::population population(pagmo::problem(UserProblem{&problem, &residuals}),
                               static_cast<std::size_t>(settings.population), seed);
  // In the place of another one: sga pairs its candidates, so their number stays even.
  if (const std::vector<double> first = problem.first_candidate(); !first.empty()) population.set_x(0, first);
  const auto generations = static_cast<unsigned>(settings.generations);
  pagmo::algorithm algorithm = algorithm_of(settings, stride, seed);
  for (unsigned done = 0; done < generations;) {
    if (generations - done < stride) algorithm = algorithm_of(settings, generations - done, seed + 1);
    population = algorithm.evolve(population);
    done = std::min(done + stride, generations);
    progress(static_cast<int>(done), population.champion_f()[0]);
  }
  return problem.repaired(population.champion_x());
}

}  // namespace toile::identify
