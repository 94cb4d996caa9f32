#include "toile/identify/homogeneous.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

Homogeneous::Homogeneous(const std::vector<TestPoint>& points) : now_(points.size()), batch_(points.size()) {
  for (const TestPoint& p : points) {
    const double c = std::cos(p.angle), s = std::sin(p.angle);
    // At 90 degrees the rounding of cos must not couple shear to a pull along an axis of the fabric.
    const double product = std::abs(c * s) < 1e-15 ? 0.0 : c * s;
    const bool is_free = p.kind == TestKind::uniaxial;
    const double held = p.kind == TestKind::equibiaxial ? p.stretch : 1.0;
    tests_.push_back({p.stretch, {c * c, s * s, product}, is_free, is_free ? 1.0 / std::sqrt(p.stretch) : held});
  }
  active_.reserve(points.size());
}

Homogeneous::Solution::Solution(std::size_t points) : lateral(points), shear(points), stress(points) {}

Homogeneous::Batch::Batch(std::size_t points)
    : C(3 * points), W(points), S(3 * points), D(6 * points), thickness(points), status(points) {}

void Homogeneous::start() {
  for (std::size_t p = 0; p < tests_.size(); ++p) now_.lateral[p] = tests_[p].start_lateral;
  std::fill(now_.shear.begin(), now_.shear.end(), 0.0);
  active_.resize(tests_.size());
  std::iota(active_.begin(), active_.end(), 0);
}

/// C of the first `count` active points in the material frame: C_ij = n_i . C n_j.
void Homogeneous::load_state(int count) {
  for (int i = 0; i < count; ++i) {
    const int p = active_[i];
    const Test& test = tests_[p];
    const auto& [cc, ss, cs] = test.turn;
    const double k = now_.shear[p];
    const double xx = test.stretch * test.stretch, yy = k * k + now_.lateral[p] * now_.lateral[p];
    const double xy = test.stretch * k;
    batch_.C[i] = cc * xx + ss * yy + 2.0 * cs * xy;
    batch_.C[count + i] = ss * xx + cc * yy - 2.0 * cs * xy;
    batch_.C[2 * count + i] = cs * (yy - xx) + (cc - ss) * xy;
  }
}

void Homogeneous::evaluate(const material::LawV1& law, const double* params, int count, double* sensitivity) {
  load_state(count);
  Batch& b = batch_;
  law.evaluate(law.context, count, b.C.data(), params, 0, b.W.data(), b.S.data(), b.D.data(), b.thickness.data(),
               sensitivity, b.status.data());
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
    const Test& test = tests_[p];
    double &lateral = now_.lateral[p], &shear = now_.shear[p], &stress = now_.stress[p];
    const TestAxes a = test_axes(test.turn, batch_.S.data(), batch_.D.data(), count, i);
    if (!test.is_free) {
      stress = test.stretch * a.Sxx;
      continue;
    }
    const Step step = newton_step(a, test.stretch, lateral, shear);
    const double length = std::max(std::abs(step.log_lateral), std::abs(step.shear) / test.stretch);
    if (!std::isfinite(length)) {
      stress = not_a_number;
      continue;
    }
    lateral *= length < last_step ? 1.0 + step.log_lateral : std::exp(step.log_lateral);
    shear += step.shear;
    if (length < last_step)
      stress = test.stretch * condensed_stress(a, a.Sxx, a.Syy, a.Sxy);
    else
      active_[remaining++] = p;
  }
  return remaining;
}

void Homogeneous::solve(const material::LawV1& law, const double* params) {
  start();
  int count = size();
  for (int k = 0; k < most_steps && count > 0; ++k) {
    evaluate(law, params, count, nullptr);
    count = newton_steps(count);
  }
  for (int i = 0; i < count; ++i) now_.stress[active_[i]] = not_a_number;
}

int Homogeneous::stress(const material::LawV1& law, const double* params, double* stress) {
  solve(law, params);
  std::copy(now_.stress.begin(), now_.stress.end(), stress);
  return static_cast<int>(
      std::count_if(now_.stress.begin(), now_.stress.end(), [](double v) { return !std::isfinite(v); }));
}

int Homogeneous::stress_and_gradient(const material::LawV1& law, const double* params, double* stress,
                                     double* gradient) {
  const int bad = this->stress(law, params, stress);
  const std::size_t n = tests_.size(), n_params = static_cast<std::size_t>(law.n_params);
  std::vector<double>& dSdp = batch_.sensitivity;
  dSdp.resize(3 * n_params * n);
  std::iota(active_.begin(), active_.end(), 0);
  evaluate(law, params, size(), dSdp.data());
  for (std::size_t i = 0; i < n; ++i) {
    const Test& test = tests_[i];
    const TestAxes a = test_axes(test.turn, batch_.S.data(), batch_.D.data(), size(), static_cast<int>(i));
    for (std::size_t k = 0; k < n_params; ++k) {
      const std::array<double, 3> g = {dSdp[k * n + i], dSdp[(n_params + k) * n + i], dSdp[(2 * n_params + k) * n + i]};
      const double x = dot(test.turn.x(), g);
      gradient[k * n + i] =
          std::isfinite(stress[i])
              ? test.stretch * (test.is_free ? condensed_stress(a, x, dot(test.turn.y(), g), dot(test.turn.g(), g)) : x)
              : not_a_number;
    }
  }
  return bad;
}

}  // namespace toile::identify
