#include "toile/identify/homogeneous.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "test_axes.hpp"

namespace toile::identify {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
/// A step this small (of ln l and k) is the last: the condensed stress has its error squared.
constexpr double last_step = 1e-7;
constexpr int most_steps = 100;
/// Longest step of ln l and of k / stretch: the energies have exponents up to 20.
constexpr double longest_step = 0.5;

struct Step {
  double log_lateral, shear;
};

/// Newton's step of the energy over (ln l, k), bounded. Where the Hessian is not positive definite it is shifted until
/// it is, so that the step always leads down.
Step newton_step(const TestAxes& a, double stretch, double l, double k) {
  const double ll = l * l;
  const double residual_l = a.Syy * ll, residual_k = a.Syy * k + a.Sxy * stretch;
  double H_ll = ll * ll * a.Dyy + 2.0 * ll * a.Syy;
  const double H_lk = ll * (k * a.Dyy + stretch * a.Dyg);
  double H_kk = k * k * a.Dyy + 2.0 * k * stretch * a.Dyg + stretch * stretch * a.Dgg + a.Syy;
  const double mean = 0.5 * (H_ll + H_kk), spread = std::hypot(0.5 * (H_ll - H_kk), H_lk);
  const double smallest = mean - spread, least = 1e-3 * (std::abs(mean) + spread);
  const double shift = smallest < least ? least - smallest + (smallest < 0.0 ? -smallest : 0.0) : 0.0;
  H_ll += shift;
  H_kk += shift;
  const double over_det = 1.0 / (H_ll * H_kk - H_lk * H_lk);
  const Step step = {-(H_kk * residual_l - H_lk * residual_k) * over_det,
                     -(H_ll * residual_k - H_lk * residual_l) * over_det};
  const double length = std::max(std::abs(step.log_lateral), std::abs(step.shear) / stretch);
  const double scale = length > longest_step ? longest_step / length : 1.0;
  return {scale * step.log_lateral, scale * step.shear};
}

}  // namespace

Homogeneous::Homogeneous(const std::vector<TestPoint>& points) : n_(static_cast<int>(points.size())) {
  for (const TestPoint& p : points) {
    const double c = std::cos(p.angle), s = std::sin(p.angle);
    // At 90 degrees the rounding of cos must not couple shear to a pull along an axis of the fabric.
    const double product = std::abs(c * s) < 1e-15 ? 0.0 : c * s;
    stretch_.push_back(p.stretch);
    cosine_squared_.push_back(c * c);
    sine_squared_.push_back(s * s);
    product_.push_back(product);
    free_.push_back(p.kind == TestKind::uniaxial ? 1.0 : 0.0);
    const double held = p.kind == TestKind::equibiaxial ? p.stretch : 1.0;
    start_lateral_.push_back(p.kind == TestKind::uniaxial ? 1.0 / std::sqrt(p.stretch) : held);
  }
  const auto n = points.size();
  shear_.resize(n);
  stress_.resize(n);
  C_.resize(3 * n);
  W_.resize(n);
  S_.resize(3 * n);
  D_.resize(6 * n);
  thickness_.resize(n);
  status_.resize(n);
  active_.reserve(n);
}

void Homogeneous::start() {
  lateral_ = start_lateral_;
  std::fill(shear_.begin(), shear_.end(), 0.0);
  active_.resize(static_cast<std::size_t>(n_));
  std::iota(active_.begin(), active_.end(), 0);
}

/// C of the first `count` active points in the material frame: C_ij = n_i . C n_j.
void Homogeneous::load_state(int count) {
  for (int i = 0; i < count; ++i) {
    const int p = active_[i];
    const double cc = cosine_squared_[p], ss = sine_squared_[p], cs = product_[p], k = shear_[p];
    const double xx = stretch_[p] * stretch_[p], yy = k * k + lateral_[p] * lateral_[p], xy = stretch_[p] * k;
    C_[i] = cc * xx + ss * yy + 2.0 * cs * xy;
    C_[count + i] = ss * xx + cc * yy - 2.0 * cs * xy;
    C_[2 * count + i] = cs * (yy - xx) + (cc - ss) * xy;
  }
}

void Homogeneous::evaluate(const material::LawV1& law, const double* params, int count, double* sensitivity) {
  load_state(count);
  law.evaluate(law.context, count, C_.data(), params, 0, W_.data(), S_.data(), D_.data(), thickness_.data(),
               sensitivity, status_.data());
  evaluations_ += count;
}

namespace {

TestAxes test_axes(const Turn& turn, const double* S, const double* D, int n, int i) {
  return to_test_axes(turn, {S[i], S[n + i], S[2 * n + i]},
                      {D[i], D[n + i], D[2 * n + i], D[3 * n + i], D[4 * n + i], D[5 * n + i]});
}

}  // namespace

/// One step of every active point; those that arrive or fail are taken out. Returns how many remain.
int Homogeneous::newton_steps(int count) {
  int remaining = 0;
  for (int i = 0; i < count; ++i) {
    const int p = active_[i];
    const Turn turn = {cosine_squared_[p], sine_squared_[p], product_[p]};
    const TestAxes a = test_axes(turn, S_.data(), D_.data(), count, i);
    if (free_[p] == 0.0) {
      stress_[p] = stretch_[p] * a.Sxx;
      continue;
    }
    const Step step = newton_step(a, stretch_[p], lateral_[p], shear_[p]);
    const double length = std::max(std::abs(step.log_lateral), std::abs(step.shear) / stretch_[p]);
    if (!std::isfinite(length)) {
      stress_[p] = not_a_number;
      continue;
    }
    lateral_[p] *= length < last_step ? 1.0 + step.log_lateral : std::exp(step.log_lateral);
    shear_[p] += step.shear;
    if (length < last_step)
      stress_[p] = stretch_[p] * condensed_stress(a, a.Sxx, a.Syy, a.Sxy);
    else
      active_[remaining++] = p;
  }
  return remaining;
}

void Homogeneous::solve(const material::LawV1& law, const double* params) {
  start();
  int count = n_;
  for (int k = 0; k < most_steps && count > 0; ++k) {
    evaluate(law, params, count, nullptr);
    count = newton_steps(count);
  }
  for (int i = 0; i < count; ++i) stress_[active_[i]] = not_a_number;
}

int Homogeneous::stress(const material::LawV1& law, const double* params, double* stress) {
  solve(law, params);
  std::copy(stress_.begin(), stress_.end(), stress);
  return static_cast<int>(std::count_if(stress_.begin(), stress_.end(), [](double v) { return !std::isfinite(v); }));
}

int Homogeneous::stress_and_gradient(const material::LawV1& law, const double* params, double* stress,
                                     double* gradient) {
  const int bad = this->stress(law, params, stress);
  const auto n = static_cast<std::size_t>(n_), n_params = static_cast<std::size_t>(law.n_params);
  sensitivity_.resize(3 * n_params * n);
  std::iota(active_.begin(), active_.end(), 0);
  evaluate(law, params, n_, sensitivity_.data());
  for (std::size_t i = 0; i < n; ++i) {
    const Turn turn = {cosine_squared_[i], sine_squared_[i], product_[i]};
    const TestAxes a = test_axes(turn, S_.data(), D_.data(), n_, static_cast<int>(i));
    for (std::size_t k = 0; k < n_params; ++k) {
      const std::array<double, 3> g = {sensitivity_[k * n + i], sensitivity_[(n_params + k) * n + i],
                                       sensitivity_[(2 * n_params + k) * n + i]};
      const double x = dot(turn.x(), g);
      gradient[k * n + i] =
          std::isfinite(stress[i])
              ? stretch_[i] * (free_[i] == 0.0 ? x : condensed_stress(a, x, dot(turn.y(), g), dot(turn.g(), g)))
              : not_a_number;
    }
  }
  return bad;
}

}  // namespace toile::identify
