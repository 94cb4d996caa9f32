#pragma once

#include <functional>
#include <optional>

#include "equilibrium/equilibrium.hpp"

namespace toile::solve {

/// Brings the stage's state to equilibrium at the parameter s. Returns Newton's iterations; nothing: it could not, and
/// the state is as it was.
using SolveAt = std::function<std::optional<int>(double s)>;
/// The same to a force residual of at most `tolerance`.
using SolveLoosely = std::function<std::optional<int>(double s, double tolerance)>;

/// Damping where there is no energy to measure (flat, floating panels): its diagonal is 1e-4 of the mean tangent
/// diagonal (doc/theory.md, "Damping").
double fallback_damping(const Equilibrium& equilibrium, double first_step);

/// Sets the damping with which the stage's first step dissipates the wanted share of its strain energy, found by trying
/// that step: a softer one moves further, so it is tried again. Where the start or the first step cannot be found with
/// little damping, it starts with more. `z`: what `solve` moves; it ends where it was.
void choose_damping(Equilibrium& equilibrium, const StageOptions& stage, RCP<Vector>& z, const SolveAt& solve);

/// Towards the wanted share of the largest strain energy, from what the last step stored and dissipated (N mm). Where
/// it dissipated more than the garment takes up, more damping would dissipate less and freeze the garment: it is
/// lowered.
void adapt_damping(Equilibrium& equilibrium, const DampingOptions& options, double largest_energy, double stored,
                   double dissipated, int iterations);
/// After a step that failed.
void stiffen_damping(Equilibrium& equilibrium);

/// Damped steps at the end of the stage, each from where the last one ended: the damping fades the faster the fewer
/// iterations a step takes, and grows where one fails. Returns what they dissipated, N mm; nothing: no damping was
/// enough.
std::optional<double> fade_damping(Equilibrium& equilibrium, const StageOptions& stage, RCP<Vector>& z,
                                   const SolveLoosely& solve);

/// Relative force residual at (z, s) without the damping force.
double undamped_residual(Equilibrium& equilibrium, const Vector& z, double s);

}  // namespace toile::solve
