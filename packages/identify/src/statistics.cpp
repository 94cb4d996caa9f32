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

int side(double x) {
  constexpr double near = 1e-6;
  return x < near ? -1 : x > 1.0 - near ? 1 : 0;
}

}  // namespace

ParameterStatistics parameter_statistics(const FitProblem& problem, const FitResult& result) {
  ParameterStatistics statistics;
  statistics.scale = scales(problem, result.params);
  for (const double x : result.x()) statistics.at_bound.push_back(side(x));
  const Eigen::MatrixXd J = scaled_jacobian(problem, result, statistics.scale);
  const Eigen::Index n = J.cols();
  statistics.noise = std::sqrt(result.chi_squared / static_cast<double>(std::max<Eigen::Index>(1, J.rows() - n)));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& sigma = svd.singularValues();
  const Eigen::MatrixXd& V = svd.matrixV();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
  std::vector<bool> open(static_cast<std::size_t>(n), false);
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool is_unseen = sigma[i] <= unseen * sigma[0];
    const double deviation = is_unseen ? std::numeric_limits<double>::infinity() : statistics.noise / sigma[i];
    statistics.combinations.push_back({{V.col(i).data(), V.col(i).data() + n}, deviation});
    if (!is_unseen) covariance += deviation * deviation * V.col(i) * V.col(i).transpose();
    for (Eigen::Index k = 0; is_unseen && k < n; ++k)
      open[static_cast<std::size_t>(k)] = open[static_cast<std::size_t>(k)] || std::abs(V(k, i)) > 1e-6;
  }
  for (Eigen::Index a = 0; a < n; ++a) {
    statistics.deviation.push_back(open[static_cast<std::size_t>(a)]
                                       ? std::numeric_limits<double>::infinity()
                                       : statistics.scale[a] * std::sqrt(covariance(a, a)));
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
