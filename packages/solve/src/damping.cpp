#include "damping.hpp"

#include <algorithm>
#include <cmath>

namespace toile::solve {

double fallback_damping(const Equilibrium& equilibrium, double first_step) {
  return 1e-4 * std::abs(equilibrium.mean_tangent_diagonal()) / equilibrium.mean_mass() * first_step;
}

void choose_damping(Equilibrium& equilibrium, const StageOptions& stage, RCP<Vector>& z, const SolveAt& solve) {
  constexpr int rounds = 3;
  constexpr double next_to_nothing = 1e-12;  // of stiffness times step squared
  equilibrium.set_damping(fallback_damping(equilibrium, stage.first_step));
  const RCP<Vector> before = z;
  bool converged = solve(0.0).has_value();
  const RCP<Vector> first = z;
  equilibrium.start_step(*first, 0.0);
  double proven = equilibrium.damping();  // the last coefficient with which the first step was found
  for (int round = 0; round < rounds && converged; ++round) {
    z = first;
    converged = solve(stage.first_step).has_value();
    if (!converged) break;
    const double now = equilibrium.dissipation(*z, stage.first_step), c = proven = equilibrium.damping();
    const double step_squared = now * stage.first_step / (c * equilibrium.mean_mass());
    const double energy = equilibrium.strain_energy(), wanted = stage.damping.fraction * energy;
    const double least = next_to_nothing * std::abs(equilibrium.mean_tangent_diagonal()) * step_squared;
    if (now <= 0.0 || energy <= least || std::abs(std::log2(wanted / now)) < 1.0) break;
    equilibrium.set_damping(c * wanted / now);
  }
  if (!converged) equilibrium.set_damping(proven);
  z = before;
  equilibrium.start_step(*z, 0.0);
}

void adapt_damping(Equilibrium& equilibrium, const DampingOptions& options, double largest_energy, double dissipated) {
  const double wanted = options.fraction * largest_energy;
  if (dissipated <= 0.0 || wanted <= 0.0) return;
  equilibrium.set_damping(equilibrium.damping() * std::clamp(wanted / dissipated, 0.2, 5.0));
}

namespace {

/// Factor of the damping after a step of so many iterations: in a narrow valley the next one must not be harder.
double fading(const std::optional<int>& iterations) {
  if (!iterations) return 10.0;
  if (*iterations <= 5) return 0.1;
  if (*iterations <= 10) return 0.3;
  return *iterations <= 20 ? 0.6 : 1.0;
}

}  // namespace

std::optional<double> fade_damping(Equilibrium& equilibrium, const StageOptions& stage, RCP<Vector>& z,
                                   const SolveAt& solve) {
  constexpr int most_steps = 100;
  const double unit = fallback_damping(equilibrium, stage.first_step);
  const double last = 1e-6 * unit, largest = 1e8 * unit;
  double coefficient = 100.0 * unit, dissipated = 0.0;
  for (int k = 0; k < most_steps && coefficient > last; ++k) {
    if (coefficient > largest) return std::nullopt;
    equilibrium.set_damping(coefficient);
    equilibrium.start_step(*z, 1.0);
    const std::optional<int> iterations = solve(1.0);
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
  equilibrium.residual(z, s, f);
  equilibrium.set_damping(damping);
  return equilibrium.imbalance(f).relative();
}

}  // namespace toile::solve
