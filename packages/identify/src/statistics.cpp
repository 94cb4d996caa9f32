#include "toile/identify/statistics.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

#include "toile/identify/residuals.hpp"

namespace toile::identify {
namespace {

/// A combination whose singular value is smaller than this part of the largest does not move the curves at all.
constexpr double unseen = 1e-12;

std::vector<double> scales(const FitProblem& problem, const std::vector<double>& params) {
  std::vector<double> all;
  for (const FreeParameter& p : problem.free())
    all.push_back(std::max(std::abs(params[p.index]), 1e-3 * (p.upper - p.lower)));
  return all;
}

/// Derivatives of the weighted residuals by p_k / scale_k.
Eigen::MatrixXd scaled_jacobian(const FitProblem& problem, const FitResult& result, const std::vector<double>& scale) {
  Residuals residuals(problem);
  residuals.chi_squared_and_derivatives(result.x());
  const std::vector<double> slopes = problem.slopes(result.x());
  const auto n = static_cast<Eigen::Index>(scale.size());
  Eigen::MatrixXd J = Eigen::Map<const Eigen::MatrixXd>(residuals.jacobian().data(), residuals.count(), n);
  for (Eigen::Index k = 0; k < n; ++k) J.col(k) *= scale[k] / slopes[k];
  return J;
}

/// A candidate that is so near to a bound or a condition, over the intervals of the parameters, is on it.
constexpr double near = 1e-6;

int side(double x) {
  return x < near ? -1 : x > 1.0 - near ? 1 : 0;
}

bool is_active(const FitProblem& problem, const LinearCondition& condition, const std::vector<double>& params) {
  double sum = 0.0, width = 0.0;
  for (std::size_t i = 0; i < params.size(); ++i)
    if (condition.factors[i] != 0.0) sum += condition.factors[i] * params[i];
  for (const FreeParameter& p : problem.free()) width += std::abs(condition.factors[p.index]) * (p.upper - p.lower);
  return width > 0.0 && sum > condition.bound - near * width;
}

/// Orthonormal directions [n_free][...] of p_k / scale_k that leave every active bound and condition as it is.
Eigen::MatrixXd feasible_directions(const FitProblem& problem, const std::vector<double>& params,
                                    const ParameterStatistics& statistics) {
  const auto n = static_cast<Eigen::Index>(statistics.scale.size());
  std::vector<Eigen::VectorXd> normals;
  for (Eigen::Index k = 0; k < n; ++k)
    if (statistics.at_bound[static_cast<std::size_t>(k)] != 0) normals.push_back(Eigen::VectorXd::Unit(n, k));
  for (const LinearCondition& condition : problem.conditions()) {
    if (!is_active(problem, condition, params)) continue;
    Eigen::VectorXd normal(n);
    for (Eigen::Index k = 0; k < n; ++k)
      normal[k] = statistics.scale[static_cast<std::size_t>(k)] * condition.factors[problem.free()[k].index];
    normals.push_back(normal.normalized());
  }
  if (normals.empty()) return Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd N(n, static_cast<Eigen::Index>(normals.size()));
  for (Eigen::Index c = 0; c < N.cols(); ++c) N.col(c) = normals[static_cast<std::size_t>(c)];
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(N);
  qr.setThreshold(1e-9);
  const Eigen::MatrixXd Q = qr.householderQ();
  return Q.rightCols(n - qr.rank());
}

/// Parameters that cannot change by a thousandth of their interval without the loss of a state.
std::vector<std::string> at_edge(const FitProblem& problem, const std::vector<double>& x) {
  constexpr double change = 1e-3;
  Residuals residuals(problem);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < x.size(); ++k) {
    bool is_lost = false;
    for (const double sign : {-1.0, 1.0}) {
      std::vector<double> moved = x;
      moved[k] = std::clamp(x[k] + sign * change, 0.0, 1.0);
      is_lost = is_lost || residuals.chi_squared(moved) >= Residuals::hopeless;
    }
    if (is_lost) names.emplace_back(problem.law().info[problem.free()[k].index].name);
  }
  return names;
}

/// [n_free]: no curve depends on the parameter. A bound that holds such a one says nothing of it.
std::vector<bool> without_effect(const Eigen::MatrixXd& J) {
  const Eigen::VectorXd effect = J.colwise().norm();
  std::vector<bool> none;
  for (const double size : effect) none.push_back(size <= unseen * effect.maxCoeff());
  return none;
}

/// Of every column of `directions`, the best determined first. `J`: derivatives along these columns.
std::vector<Combination> combinations(const Eigen::MatrixXd& J, const Eigen::MatrixXd& directions, double noise) {
  std::vector<Combination> all;
  if (J.cols() == 0) return all;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& sigma = svd.singularValues();
  const Eigen::MatrixXd V = directions * svd.matrixV();
  for (Eigen::Index i = 0; i < V.cols(); ++i) {
    const bool is_unseen = sigma[i] <= unseen * sigma[0];
    all.push_back({{V.col(i).data(), V.col(i).data() + V.rows()},
                   is_unseen ? std::numeric_limits<double>::infinity() : noise / sigma[i]});
  }
  return all;
}

}  // namespace

ParameterStatistics parameter_statistics(const FitProblem& problem, const FitResult& result) {
  ParameterStatistics statistics;
  statistics.scale = scales(problem, result.params);
  for (const double x : result.x()) statistics.at_bound.push_back(side(x));
  statistics.at_edge = at_edge(problem, result.x());
  for (const LinearCondition& condition : problem.conditions())
    if (is_active(problem, condition, result.params)) statistics.active_conditions.push_back(condition.name);
  const Eigen::MatrixXd directions = feasible_directions(problem, result.params, statistics);
  const Eigen::MatrixXd full = scaled_jacobian(problem, result, statistics.scale), J = full * directions;
  statistics.noise =
      std::sqrt(result.chi_squared / static_cast<double>(std::max<Eigen::Index>(1, J.rows() - J.cols())));
  statistics.combinations = combinations(J, directions, statistics.noise);

  const Eigen::Index n = directions.rows();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  std::vector<bool>& open = statistics.open;
  open = without_effect(full);
  for (const Combination& combination : statistics.combinations) {
    const Eigen::Map<const Eigen::VectorXd> v(combination.factors.data(), n);
    if (std::isfinite(combination.deviation))
      covariance += combination.deviation * combination.deviation * v * v.transpose();
    else
      for (std::size_t k = 0; k < open.size(); ++k) open[k] = open[k] || std::abs(combination.factors[k]) > 1e-6;
  }
  // Neither zero nor what the other directions leave may be read as the covariance of a parameter that has none.
  for (Eigen::Index a = 0; a < n; ++a) {
    statistics.held.push_back(directions.row(a).norm() < 1e-9);
    if (!statistics.held[a] && !open[a]) continue;
    covariance.row(a).setConstant(std::numeric_limits<double>::quiet_NaN());
    covariance.col(a).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  for (Eigen::Index a = 0; a < n; ++a) {
    statistics.deviation.push_back(statistics.scale[a] * std::sqrt(covariance(a, a)));
    if (open[a]) statistics.deviation.back() = std::numeric_limits<double>::infinity();
    for (Eigen::Index b = 0; b < n; ++b) {
      statistics.covariance.push_back(statistics.scale[a] * statistics.scale[b] * covariance(a, b));
      statistics.correlation.push_back(covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b)));
    }
  }
  return statistics;
}

std::string combination_text(const FitProblem& problem, const Combination& combination) {
  const std::vector<double>& f = combination.factors;
  std::vector<std::size_t> order(f.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return std::abs(f[a]) > std::abs(f[b]); });
  const double sign = f[order[0]] < 0.0 ? -1.0 : 1.0, largest = std::abs(f[order[0]]);
  std::ostringstream text;
  text.precision(2);
  for (const std::size_t k : order) {
    if (std::abs(f[k]) < 0.2 * largest) break;
    const double factor = sign * f[k];
    text << (k == order[0]  ? ""
             : factor < 0.0 ? " - "
                            : " + ")
         << std::abs(factor) << " " << problem.law().info[problem.free()[k].index].name;
  }
  return text.str();
}

}  // namespace toile::identify
