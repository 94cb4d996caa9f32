#include "toile/identify/clamped_strip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "strip_equations.hpp"

namespace toile::identify {
namespace {

using Vector = StripEquations::Vector;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
/// A step this small (of positions over the width) is the last: the force has its error squared.
constexpr double last_correction = 1e-7;
constexpr int most_iterations = 25;
/// Part of the way to the next stretch that a step of the load has at least.
constexpr double least_part = 1.0 / 256.0;
/// Longest step of the load, as a part of the length: from rest to the first stretch, say.
constexpr double longest_load_step = 0.1;

/// Equilibrium at a displacement u of the moving end.
struct StripState {
  double u;
  Vector x, v;   ///< positions, and their derivative by u
  Vector dv;     ///< difference quotient of v over the step that led here
  double force;  ///< of the strip of unit width and thickness: the nominal stress
};

/// The Newton direction of the energy, and whether the tangent is positive definite without a shift.
struct Direction {
  Vector step;
  bool is_stable;
};

/// Where the tangent is not positive definite it is shifted until it is, so that the step leads down.
std::optional<Direction> direction(StripEquations& equations) {
  constexpr double first_shift = 1e-3, last_shift = 1e3;
  const bool is_stable = equations.factorise();
  bool is_positive = is_stable;
  for (double shift = first_shift; !is_positive && shift <= last_shift; shift *= 10.0)
    is_positive = equations.factorise(shift);
  if (!is_positive) return std::nullopt;
  return Direction{equations.solve(equations.gradient()), is_stable};
}

/// Moves `x` along `step` as far as lowers the energy enough (Armijo) and evaluates there. NaN if nothing does.
double descend(StripEquations& equations, Vector& x, double energy, const Vector& step) {
  constexpr int halvings = 12;
  constexpr double enough = 1e-4, rounding = 1e-13;
  const double slope = equations.gradient().dot(step);
  double part = 1.0;
  for (int i = 0; i < halvings; ++i, part *= 0.5) {
    const Vector next = x + part * step;
    const double value = equations.evaluate(next);
    if (value > energy + enough * part * slope + rounding * std::abs(energy) || std::isnan(value)) continue;
    x = next;
    return value;
  }
  return no_value;
}

/// Equilibrium with the end at `u`, from positions `x` that have it there.
std::optional<StripState> equilibrium(StripEquations& equations, double u, Vector x) {
  double energy = equations.evaluate(x);
  for (int i = 0; i < most_iterations && std::isfinite(energy); ++i) {
    const auto d = direction(equations);
    if (!d) return std::nullopt;
    if (d->step.lpNorm<Eigen::Infinity>() < last_correction) {
      if (!d->is_stable) return std::nullopt;
      Vector v = equations.pull() + equations.solve(equations.pulled());
      const double force = v.dot(equations.gradient());
      return StripState{u, x + d->step, std::move(v), Vector::Zero(x.size()), force};
    }
    energy = descend(equations, x, energy, d->step);
  }
  return std::nullopt;
}

/// The state at `end`, from `state` on, in steps that are cut where Newton's method fails.
std::optional<StripState> load(StripEquations& equations, StripState state, double end) {
  const double way = end - state.u;
  const double longest = longest_load_step * equations.length();
  double step = way / std::max(1.0, std::ceil(std::abs(way) / longest));
  const double least = least_part * std::abs(step);
  while (state.u != end) {
    const bool is_last = std::abs(end - state.u) <= std::abs(step) * (1.0 + 1e-9);
    const double u = is_last ? end : state.u + step, h = u - state.u;
    auto next = equilibrium(equations, u, state.x + h * state.v + 0.5 * h * h * state.dv);
    if (next) {
      Vector dv = (next->v - state.v) / h;
      state = std::move(*next);
      state.dv = std::move(dv);
      continue;
    }
    step *= 0.5;
    if (std::abs(step) < least) return std::nullopt;
  }
  return state;
}

}  // namespace

int StripSpecimen::elements_along() const {
  return std::max(2, static_cast<int>(std::lround(elements_across * std::sqrt(length / width))));
}

ClampedStrip::ClampedStrip(const StripSpecimen& specimen, double angle, std::vector<double> stretches)
    : stretches_(std::move(stretches)), equations_(std::make_unique<StripEquations>(specimen, angle)) {}
ClampedStrip::~ClampedStrip() = default;

long ClampedStrip::factorisations() const {
  return equations_->factorisations();
}

int ClampedStrip::follow(const material::LawV1& law, const double* params, double* stress, double* gradient) {
  StripEquations& equations = *equations_;
  equations.set_law(law, params);
  const std::size_t n = stretches_.size();
  std::fill_n(stress, n, no_value);
  if (gradient != nullptr) std::fill_n(gradient, n * static_cast<std::size_t>(law.n_params), no_value);
  std::optional<StripState> state = equilibrium(equations, 0.0, equations.at_rest());
  for (std::size_t i = 0; i < n && state; ++i) {
    state = load(equations, std::move(*state), (stretches_[i] - 1.0) * equations.length());
    if (!state) break;
    stress[i] = state->force;
    if (gradient != nullptr) equations.sensitivities(state->x, state->v, gradient + i, n);
  }
  return static_cast<int>(std::count_if(stress, stress + n, [](double P) { return !std::isfinite(P); }));
}

int ClampedStrip::stress(const material::LawV1& law, const double* params, double* stress) {
  return follow(law, params, stress, nullptr);
}

int ClampedStrip::stress_and_gradient(const material::LawV1& law, const double* params, double* stress,
                                      double* gradient) {
  return follow(law, params, stress, gradient);
}

}  // namespace toile::identify
