#include "toile/identify/residuals.hpp"

#include <algorithm>
#include <cmath>

#include "toile/base/error.hpp"

namespace toile::identify {

namespace {

std::vector<Curve> fitted_curves(const FitProblem& problem) {
  std::vector<Curve> fitted;
  for (const Curve& curve : problem.curves())
    if (curve.weight > 0.0) fitted.push_back(curve);
  return fitted;
}

}  // namespace

Residuals::Residuals(const FitProblem& problem, Fidelity fidelity)
    : problem_(problem), model_(forward_model(fitted_curves(problem), fidelity)) {
  for (const Curve& curve : fitted_curves(problem)) {
    double largest = 0.0;
    for (const double value : curve.stress) largest = std::max(largest, std::abs(value));
    for (std::size_t i = 0; i < curve.stress.size(); ++i) {
      if (i > 0) {
        rise_from_.push_back(static_cast<int>(data_.size()) - 1);
        rise_scale_.push_back(1.0 / largest);
      }
      data_.push_back(curve.stress[i]);
      factor_.push_back(std::sqrt(curve.weight) / curve.deviation[i]);
    }
  }
  const std::size_t n = data_.size(), n_free = problem.free().size();
  stress_.resize(n);
  residual_.resize(n);
  gradient_.resize(n * static_cast<std::size_t>(problem.law().n_params));
  jacobian_.resize(n * n_free);
  rise_.resize(rise_from_.size());
  rise_jacobian_.resize(rise_from_.size() * n_free);
}

double Residuals::finish() {
  double sum = 0.0;
  for (std::size_t i = 0; i < data_.size(); ++i) {
    residual_[i] = factor_[i] * (stress_[i] - data_[i]);
    sum += residual_[i] * residual_[i];
  }
  for (std::size_t r = 0; r < rise_.size(); ++r)
    rise_[r] = rise_scale_[r] * (stress_[rise_from_[r] + 1] - stress_[rise_from_[r]]);
  return std::isfinite(sum) ? std::min(sum, hopeless) : hopeless;
}

double Residuals::chi_squared(const std::vector<double>& x) {
  if (x == last_) return chi_squared_;
  model_->stress(problem_.law(), problem_.params(x).data(), stress_.data());
  last_ = x;
  has_derivatives_ = false;
  return chi_squared_ = finish();
}

double Residuals::chi_squared_and_derivatives(const std::vector<double>& x) {
  if (x == last_ && has_derivatives_) return chi_squared_;
  model_->stress_and_gradient(problem_.law(), problem_.params(x).data(), stress_.data(), gradient_.data());
  const std::vector<double> slopes = problem_.slopes(x);
  const std::size_t n = data_.size(), n_rises = rise_.size();
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const double* by_param = gradient_.data() + static_cast<std::size_t>(problem_.free()[k].index) * n;
    for (std::size_t i = 0; i < n; ++i) jacobian_[k * n + i] = factor_[i] * slopes[k] * by_param[i];
    for (std::size_t r = 0; r < n_rises; ++r)
      rise_jacobian_[k * n_rises + r] =
          rise_scale_[r] * slopes[k] * (by_param[rise_from_[r] + 1] - by_param[rise_from_[r]]);
  }
  last_ = x;
  has_derivatives_ = true;
  chi_squared_ = finish();
  if (chi_squared_ < hopeless) require_derivatives();
  return chi_squared_;
}

void Residuals::require_derivatives() const {
  const std::size_t n = data_.size();
  for (std::size_t k = 0; k * n < jacobian_.size(); ++k)
    for (std::size_t i = 0; i < n; ++i) {
      if (std::isfinite(jacobian_[k * n + i])) continue;
      throw base::Error(
          base::ExitCode::solve_failed,
          "the fit cannot go on: the stress of fitted point " + std::to_string(i + 1) + " of " + std::to_string(n) +
              " (curves in the order of their names in Data) has no derivative by parameter \"" +
              problem_.law().info[problem_.free()[k].index].name + "\"; see whether the law is differentiable there");
    }
}

double Residuals::merit() const {
  constexpr double cost_of_a_fall = 1e6;
  if (!problem_.keeps_rising()) return chi_squared_;
  return std::min(hopeless, chi_squared_ + cost_of_a_fall * count() * std::max(0.0, -smallest_rise()));
}

double Residuals::smallest_rise() const {
  return rise_.empty() ? 0.0 : *std::min_element(rise_.begin(), rise_.end());
}

}  // namespace toile::identify
