#include "polish.hpp"

#include <nlopt.h>

#include <Eigen/Dense>
#include <algorithm>
#include <memory>

namespace toile::identify {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int most_rounds = 20;
constexpr int most_evaluations = 300;
constexpr double accuracy = 1e-12;
/// A round that gains less than this part of chi^2 is the last.
constexpr double least_gain = 1e-8;
constexpr double condition_tolerance = 1e-10;
/// Singular values of the Jacobian are taken as at least this part of the largest: bounds the steps along combinations
/// that the data hardly see.
constexpr double least_singular_value = 1e-5;

/// The problem in variables y, x = origin + T y, in which chi^2 is nearly a sphere: T = V diag(1/sigma) from the
/// Jacobian at the origin. Coefficients of a polynomial, say, are too badly conditioned for a quasi-Newton method.
struct Context {
  const FitProblem& problem;
  Residuals& residuals;
  VectorXd origin;
  MatrixXd T;
  const std::function<void(double)>& progress;
  double smallest;  ///< chi^2

  std::vector<double> x(const double* y) const {
    const VectorXd x = origin + T * Eigen::Map<const VectorXd>(y, T.cols());
    return {x.data(), x.data() + x.size()};
  }
  Eigen::Map<const MatrixXd> jacobian() const { return {residuals.jacobian().data(), residuals.count(), T.rows()}; }
};

Context context_at(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x,
                   const std::function<void(double)>& progress) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const double chi = residuals.chi_squared_and_derivatives(x);
  Context context = {problem,  residuals, Eigen::Map<const VectorXd>(x.data(), n), MatrixXd::Identity(n, n),
                     progress, chi};
  const Eigen::JacobiSVD<MatrixXd> svd(context.jacobian(), Eigen::ComputeThinU | Eigen::ComputeFullV);
  const VectorXd& sigma = svd.singularValues();
  if (sigma[0] > 0.0)
    context.T = svd.matrixV() * sigma.cwiseMax(least_singular_value * sigma[0]).cwiseInverse().asDiagonal();
  return context;
}

double objective(unsigned n, const double* y, double* gradient, void* data) {
  Context& context = *static_cast<Context*>(data);
  if (gradient == nullptr) return context.residuals.chi_squared(context.x(y));
  const double chi = context.residuals.chi_squared_and_derivatives(context.x(y));
  context.smallest = std::min(context.smallest, chi);
  context.progress(context.smallest);
  Eigen::Map<VectorXd> g(gradient, n);
  g.setZero();
  if (chi < Residuals::hopeless) {
    const Eigen::Map<const VectorXd> r(context.residuals.residual().data(), context.residuals.count());
    g = 2.0 * (context.T.transpose() * (context.jacobian().transpose() * r));
  }
  return chi;
}

/// -x <= 0 and x - 1 <= 0.
void bounds(unsigned, double* result, unsigned n, const double* y, double* gradient, void* data) {
  const Context& context = *static_cast<Context*>(data);
  const std::vector<double> x = context.x(y);
  for (unsigned k = 0; k < n; ++k) {
    result[k] = -x[k];
    result[n + k] = x[k] - 1.0;
  }
  if (gradient == nullptr) return;
  Eigen::Map<RowMajor> g(gradient, 2 * n, n);
  g.topRows(n) = -context.T;
  g.bottomRows(n) = context.T;
}

/// factors . params - bound <= 0 of every condition.
void conditions(unsigned count, double* result, unsigned n, const double* y, double* gradient, void* data) {
  const Context& context = *static_cast<Context*>(data);
  const FitProblem& problem = context.problem;
  const std::vector<double> x = context.x(y), params = problem.params(x), slopes = problem.slopes(x);
  RowMajor by_x(count, n);
  for (unsigned c = 0; c < count; ++c) {
    const LinearCondition& condition = problem.conditions()[c];
    result[c] = -condition.bound;
    for (std::size_t i = 0; i < params.size(); ++i)
      if (condition.factors[i] != 0.0) result[c] += condition.factors[i] * params[i];
    for (unsigned k = 0; k < n; ++k)
      by_x(c, k) = condition.factors[static_cast<std::size_t>(problem.free()[k].index)] * slopes[k];
  }
  if (gradient != nullptr) Eigen::Map<RowMajor>(gradient, count, n) = by_x * context.T;
}

/// Minus every rise <= 0.
void falls(unsigned count, double* result, unsigned n, const double* y, double* gradient, void* data) {
  const Context& context = *static_cast<Context*>(data);
  Residuals& residuals = context.residuals;
  if (gradient == nullptr)
    residuals.chi_squared(context.x(y));
  else
    residuals.chi_squared_and_derivatives(context.x(y));
  for (unsigned r = 0; r < count; ++r) result[r] = -residuals.rise()[r];
  if (gradient == nullptr) return;
  const Eigen::Map<const MatrixXd> by_x(residuals.rise_jacobian().data(), count, n);
  Eigen::Map<RowMajor>(gradient, count, n) = -(by_x * context.T);
}

void constrain(nlopt_opt opt, std::size_t count, nlopt_mfunc function, Context& context) {
  const std::vector<double> slack(count, condition_tolerance);
  if (count > 0) nlopt_add_inequality_mconstraint(opt, static_cast<unsigned>(count), function, &context, slack.data());
}

/// One run of SLSQP from `x`. A failure of the optimiser leaves its best point, which is judged like any other.
std::vector<double> sequential_programming(const FitProblem& problem, Residuals& residuals,
                                           const std::vector<double>& x, const std::function<void(double)>& progress) {
  Context context = context_at(problem, residuals, x, progress);
  const auto n = static_cast<unsigned>(x.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> optimiser(nlopt_create(NLOPT_LD_SLSQP, n),
                                                                         &nlopt_destroy);
  nlopt_set_min_objective(optimiser.get(), objective, &context);
  constrain(optimiser.get(), 2 * x.size(), bounds, context);
  constrain(optimiser.get(), problem.conditions().size(), conditions, context);
  if (problem.keeps_rising()) constrain(optimiser.get(), static_cast<std::size_t>(residuals.rises()), falls, context);
  nlopt_set_ftol_rel(optimiser.get(), accuracy);
  nlopt_set_maxeval(optimiser.get(), most_evaluations);
  std::vector<double> y(x.size(), 0.0);
  double value = 0.0;
  nlopt_optimize(optimiser.get(), y.data(), &value);
  std::vector<double> result = context.x(y.data());
  for (double& v : result) v = std::clamp(v, 0.0, 1.0);
  return result;
}

bool is_usable(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x) {
  return problem.is_valid(x) && residuals.chi_squared(x) < Residuals::hopeless &&
         (!problem.keeps_rising() || residuals.smallest_rise() >= 0.0);
}

/// The last point on the way from `from`, which is taken to be accepted, to `to` that is.
std::vector<double> last_accepted(const std::vector<double>& from, const std::vector<double>& to,
                                  const std::function<bool(const std::vector<double>&)>& is_accepted) {
  constexpr int halvings = 40;
  if (is_accepted(to)) return to;
  std::vector<double> best = from, between(from.size());
  double good = 0.0, bad = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (good + bad);
    for (std::size_t k = 0; k < from.size(); ++k) between[k] = from[k] + middle * (to[k] - from[k]);
    const bool accepted = is_accepted(between);
    if (accepted) best = between;
    (accepted ? good : bad) = middle;
  }
  return best;
}

/// The last usable point on the way from `from`, which is usable, to `to`. What needs no evaluation of the curves is
/// met first: they may be costly.
std::vector<double> last_usable(const FitProblem& problem, Residuals& residuals, const std::vector<double>& from,
                                const std::vector<double>& to) {
  const auto valid = last_accepted(from, to, [&](const auto& x) { return problem.is_valid(x); });
  return last_accepted(from, valid, [&](const auto& x) { return is_usable(problem, residuals, x); });
}

}  // namespace

std::vector<double> polished(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x,
                             const std::function<void(double)>& progress) {
  std::vector<double> best = x;
  bool usable = is_usable(problem, residuals, x);
  double chi = residuals.chi_squared(x);
  for (int round = 0; round < most_rounds && chi < Residuals::hopeless; ++round) {
    std::vector<double> next = sequential_programming(problem, residuals, best, progress);
    if (usable) next = last_usable(problem, residuals, best, next);
    const bool next_usable = is_usable(problem, residuals, next);
    const double next_chi = residuals.chi_squared(next);
    const bool becomes_usable = next_usable && !usable;
    if (!becomes_usable && next_chi > chi * (1.0 - least_gain)) break;
    if (usable && !next_usable) break;
    best = next;
    chi = next_chi;
    usable = next_usable;
  }
  return best;
}

}  // namespace toile::identify
