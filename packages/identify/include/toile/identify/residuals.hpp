#pragma once

#include <vector>

#include "toile/identify/curve_models.hpp"
#include "toile/identify/problem.hpp"

namespace toile::identify {

/// Sum of weighted squared residuals of a problem's fitted curves: chi^2 = sum_i w_i ((P_i - d_i)/sigma_i)^2, and the
/// rises of the fit from each stretch to the next. Holds work arrays: one object a thread. What was evaluated last is
/// not evaluated again.
class Residuals {
 public:
  explicit Residuals(const FitProblem& problem, Fidelity fidelity = Fidelity::as_asked);

  int count() const { return static_cast<int>(data_.size()); }  ///< fitted points
  int rises() const { return static_cast<int>(rise_.size()); }

  /// Each evaluates the candidate x [n_free]; a candidate without a solution at some point has chi^2 = `hopeless`.
  double chi_squared(const std::vector<double>& x);
  /// With derivatives: residual() [count] (weighted), jacobian() [n_free][count] by x, rise() [rises] over each curve's
  /// largest stress and its derivatives rise_jacobian() [n_free][rises]. Throws Error (solve_failed), naming the
  /// parameter, if a derivative of a candidate that has every state is not a number.
  double chi_squared_and_derivatives(const std::vector<double>& x);

  const std::vector<double>& residual() const { return residual_; }
  const std::vector<double>& jacobian() const { return jacobian_; }
  const std::vector<double>& rise() const { return rise_; }
  const std::vector<double>& rise_jacobian() const { return rise_jacobian_; }
  /// Smallest rise of the last evaluation; negative: the stress falls somewhere.
  double smallest_rise() const;
  /// chi^2 of the last evaluation, and if the stress must rise a cost of its falls that no fit gains.
  double merit() const;

  static constexpr double hopeless = 1e30;

 private:
  double finish();
  void require_derivatives() const;

  const FitProblem& problem_;
  std::unique_ptr<ForwardModel> model_;
  /// The candidate of the last evaluation, its chi^2, and whether its derivatives are there.
  std::vector<double> last_;
  double chi_squared_ = hopeless;
  bool has_derivatives_ = false;
  std::vector<double> data_, factor_;  ///< [count]; factor: sqrt(weight) / sigma
  std::vector<int> rise_from_;         ///< a rise is from this point to the next
  std::vector<double> rise_scale_;
  std::vector<double> stress_, gradient_, residual_, jacobian_, rise_, rise_jacobian_;
};

}  // namespace toile::identify
