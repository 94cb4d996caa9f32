#include "polish.hpp"

#include <nlopt.h>

#include <algorithm>
#include <memory>

namespace toile::identify {
namespace {

constexpr int most_evaluations = 2000;
constexpr double accuracy = 1e-12;
constexpr double condition_tolerance = 1e-10;

struct Context {
  const FitProblem& problem;
  Residuals& residuals;
};

std::vector<double> candidate(unsigned n, const double* x) {
  return {x, x + n};
}

/// chi^2 over the number of points, so that it is of order one.
double objective(unsigned n, const double* x, double* gradient, void* data) {
  const Context& context = *static_cast<Context*>(data);
  Residuals& residuals = context.residuals;
  const auto count = static_cast<std::size_t>(residuals.count());
  const double scale = 1.0 / static_cast<double>(count);
  if (gradient == nullptr) return scale * residuals.chi_squared(candidate(n, x));
  const double chi = residuals.chi_squared_and_derivatives(candidate(n, x));
  for (unsigned k = 0; k < n; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += residuals.jacobian()[k * count + i] * residuals.residual()[i];
    gradient[k] = chi < Residuals::hopeless ? 2.0 * scale * sum : 0.0;
  }
  return scale * chi;
}

/// factors . params - bound <= 0 of every condition.
void conditions(unsigned, double* result, unsigned n, const double* x, double* gradient, void* data) {
  const FitProblem& problem = static_cast<Context*>(data)->problem;
  const std::vector<double> params = problem.params(candidate(n, x)), slopes = problem.slopes(candidate(n, x));
  for (std::size_t c = 0; c < problem.conditions().size(); ++c) {
    const LinearCondition& condition = problem.conditions()[c];
    result[c] = -condition.bound;
    for (std::size_t i = 0; i < params.size(); ++i)
      if (condition.factors[i] != 0.0) result[c] += condition.factors[i] * params[i];
    for (unsigned k = 0; gradient != nullptr && k < n; ++k)
      gradient[c * n + k] = condition.factors[static_cast<std::size_t>(problem.free()[k].index)] * slopes[k];
  }
}

/// Minus every rise <= 0.
void falls(unsigned count, double* result, unsigned n, const double* x, double* gradient, void* data) {
  Residuals& residuals = static_cast<Context*>(data)->residuals;
  if (gradient == nullptr)
    residuals.chi_squared(candidate(n, x));
  else
    residuals.chi_squared_and_derivatives(candidate(n, x));
  for (unsigned r = 0; r < count; ++r) {
    result[r] = -residuals.rise()[r];
    for (unsigned k = 0; gradient != nullptr && k < n; ++k)
      gradient[r * n + k] = -residuals.rise_jacobian()[static_cast<std::size_t>(k) * count + r];
  }
}

/// The last point on the way from `from` (usable) to `to` that is.
std::vector<double> last_usable(const FitProblem& problem, Residuals& residuals, const std::vector<double>& from,
                                const std::vector<double>& to) {
  constexpr int halvings = 40;
  const auto usable = [&](const std::vector<double>& x) {
    if (!problem.is_valid(x)) return false;
    return residuals.chi_squared(x) < Residuals::hopeless &&
           (!problem.keeps_rising() || residuals.smallest_rise() >= 0.0);
  };
  if (usable(to)) return to;
  std::vector<double> best = from, between(from.size());
  double good = 0.0, bad = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (good + bad);
    for (std::size_t k = 0; k < from.size(); ++k) between[k] = from[k] + middle * (to[k] - from[k]);
    if (usable(between)) {
      best = between;
      good = middle;
    } else {
      bad = middle;
    }
  }
  return best;
}

}  // namespace

std::vector<double> polished(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x) {
  const auto n = static_cast<unsigned>(x.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(nlopt_create(NLOPT_LD_SLSQP, n),
                                                                         &nlopt_destroy);
  nlopt_opt opt = optimiser.get();
  Context context = {problem, residuals};
  nlopt_set_lower_bounds1(opt, 0.0);
  nlopt_set_upper_bounds1(opt, 1.0);
  nlopt_set_min_objective(opt, objective, &context);
  const std::vector<double> condition_slack(problem.conditions().size(), condition_tolerance);
  if (!condition_slack.empty())
    nlopt_add_inequality_mconstraint(opt, static_cast<unsigned>(condition_slack.size()), conditions, &context,
                                     condition_slack.data());
  const std::vector<double> rise_slack(static_cast<std::size_t>(residuals.rises()), condition_tolerance);
  if (problem.keeps_rising())
    nlopt_add_inequality_mconstraint(opt, static_cast<unsigned>(rise_slack.size()), falls, &context, rise_slack.data());
  nlopt_set_ftol_rel(opt, accuracy);
  nlopt_set_maxeval(opt, most_evaluations);
  std::vector<double> result = x;
  for (double& value : result) value = std::clamp(value, 0.0, 1.0);
  double value = 0.0;
  // A failure of the optimiser leaves its best point, which is judged like any other.
  nlopt_optimize(opt, result.data(), &value);
  result = last_usable(problem, residuals, x, result);
  return residuals.chi_squared(result) <= residuals.chi_squared(x) ? result : x;
}

}  // namespace toile::identify
