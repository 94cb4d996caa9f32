#include "path/damping.hpp"

#include <algorithm>
#include <cmath>

namespace toile::solve {

double fallback_damping(const Equilibrium& equilibrium, double first_step) {
  return 1e-4 * std::abs(equilibrium.measures().stiffness) / equilibrium.measures().mass * first_step;
}

namespace {

/// Factor of the damping after a step of so many iterations: in a narrow valley the next one must not be harder.
double fading(const std::optional<int>& iterations) {
  if (!iterations) return 10.0;
  if (*iterations <= 5) return 0.1;
  if (*iterations <= 10) return 0.3;
  return *iterations <= 20 ? 0.6 : 1.0;
}

/// What one damped step did, N mm.
struct Work {
  double stored, dissipated;
  /// More damping then lets the step dissipate less: of a step against a spring k the damper c dissipates
  /// c f^2/(c + k)^2, which is largest at c = k, where it takes twice what the spring stores.
  bool overdamped() const { return dissipated > 2.0 * std::max(0.0, stored); }
  /// Of the damping, to where the spring takes as much as the damper.
  double relief() const { return std::clamp(2.0 * stored / dissipated, 0.01, 0.2); }
};

/// Share of the energy below which a step dissipates nothing: it has moved the garment by round-off only, as where
/// closed seams are to be closed, and does not tell what the damping does. Damping that is raised until such a step
/// dissipates is so stiff that positions cannot be resolved to the tolerance.
constexpr double round_off = 1e-16;

/// Ten times the damping, and again, until the stage's start is found and its first step from there: `z` is the start
/// then. False: none was enough, and the damping is as it was.
bool find_enough(Equilibrium& equilibrium, const StageOptions& stage, RCP<Vector>& z, const SolveAt& solve) {
  constexpr int most = 9;
  const double least = equilibrium.damping();
  const RCP<Vector> before = z;
  for (int k = 0; k < most; ++k) {
    z = before;
    equilibrium.start_step(*z, 0.0);
    if (solve(0.0)) {
      const RCP<Vector> first = z;
      equilibrium.start_step(*first, 0.0);
      const bool stepped = solve(stage.first_step).has_value();
      z = first;
      if (stepped) return true;
    }
    equilibrium.set_damping(10.0 * equilibrium.damping());
  }
  equilibrium.set_damping(least);
  z = before;
  equilibrium.start_step(*z, 0.0);
  return false;
}

}  // namespace

void choose_damping(Equilibrium& equilibrium, const StageOptions& stage, RCP<Vector>& z, const SolveAt& solve) {
  constexpr int rounds = 3;
  constexpr double next_to_nothing = 1e-12;  // of stiffness times step squared
  equilibrium.set_damping(fallback_damping(equilibrium, stage.first_step));
  const RCP<Vector> before = z;
  if (!find_enough(equilibrium, stage, z, solve)) return;
  const RCP<Vector> first = z;
  Vector f(first->getMap());
  const double at_start = equilibrium.residual(*first, 0.0, f).strain_energy;
  const double enough = equilibrium.damping();
  double proven = enough;  // the last coefficient with which the first step was found
  for (int round = 0; round < rounds; ++round) {
    z = first;
    if (!solve(stage.first_step)) break;
    const double now = equilibrium.dissipation(*z, stage.first_step), c = proven = equilibrium.damping();
    const double step_squared = now * stage.first_step / (c * equilibrium.measures().mass);
    const double energy = equilibrium.residual(*z, stage.first_step, f).strain_energy;
    const double wanted = stage.damping.fraction * energy;
    const double least = next_to_nothing * std::abs(equilibrium.measures().stiffness) * step_squared;
    if (now <= round_off * energy || energy <= least) break;
    const Work work{energy - at_start, now};
    if (work.overdamped())
      equilibrium.set_damping(c * work.relief());
    else if (std::abs(std::log2(wanted / now)) < 1.0)
      break;
    else
      equilibrium.set_damping(c * wanted / now);
  }
  // The path starts at the stage's start again, which may need more than the first step.
  for (; proven < enough; proven = std::min(10.0 * proven, enough)) {
    equilibrium.set_damping(proven);
    z = before;
    equilibrium.start_step(*z, 0.0);
    if (solve(0.0)) break;
  }
  equilibrium.set_damping(proven);
  z = before;
  equilibrium.start_step(*z, 0.0);
}

void adapt_damping(Equilibrium& equilibrium, const DampingOptions& options, double largest_energy, double stored,
                   double dissipated, int iterations) {
  const double wanted = options.fraction * largest_energy;
  if (dissipated <= round_off * largest_energy || wanted <= 0.0) return;
  const Work work{stored, dissipated};
  const double factor =
      work.overdamped() ? std::max(work.relief(), fading(iterations)) : std::clamp(wanted / dissipated, 0.2, 5.0);
  equilibrium.set_damping(equilibrium.damping() * factor);
}

void stiffen_damping(Equilibrium& equilibrium) {
  equilibrium.set_damping(equilibrium.damping() * fading(std::nullopt));
}

std::optional<double> fade_damping(Equilibrium& equilibrium, const StageOptions& stage, RCP<Vector>& z,
                                   const SolveLoosely& solve) {
  constexpr int most_steps = 200;
  constexpr double loosely = 0.05;  // of what is left without damping: these states are no result
  const double unit = fallback_damping(equilibrium, stage.first_step);
  const double last = 1e-6 * unit, largest = 1e8 * unit;
  double coefficient = 100.0 * unit, dissipated = 0.0;
  for (int k = 0; k < most_steps && coefficient > last; ++k) {
    if (coefficient > largest) return std::nullopt;
    equilibrium.set_damping(coefficient);
    equilibrium.start_step(*z, 1.0);
    const std::optional<int> iterations = solve(1.0, loosely * undamped_residual(equilibrium, *z, 1.0));
    if (iterations) dissipated += equilibrium.dissipation(*z, 1.0);
    coefficient *= fading(iterations);
  }
  equilibrium.start_step(*z, 1.0);
  return dissipated;
}

double undamped_residual(Equilibrium& equilibrium, const Vector& z, double s) {
  const double damping = equilibrium.damping();
  equilibrium.set_damping(0.0);
  Vector f(z.getMap());
  const Evaluation undamped = equilibrium.residual(z, s, f);
  equilibrium.set_damping(damping);
  return undamped.imbalance.relative();
}

}  // namespace toile::solve
