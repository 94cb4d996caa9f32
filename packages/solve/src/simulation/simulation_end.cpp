// The final state of a stage.
#include <sstream>

#include "simulation/simulation_data.hpp"
#include "toile/base/error.hpp"
#include "watch/furthest_move.hpp"

namespace toile::solve {

namespace {

bool pins_carry(const ForceBalance& balance) {
  constexpr double allowed = 1e-6;
  return balance.pin_magnitude > allowed * balance.magnitude;
}

}  // namespace

// The undamped equilibrium at fixed load, with the contact offset iterated until it agrees with the thickness.
bool Simulation::Data::finish() {
  constexpr double same_offset = 1e-7;  // mm
  constexpr int most_rounds = 30, rounds_in_place = 2;
  constexpr double next_to_nothing = 1e-5;  // of the forces
  equilibrium->set_damping(0.0);
  for (int round = 0; round < most_rounds; ++round) {
    if (!solve(1.0)) return false;
    const bool same = equilibrium->update_thickness(*z, 1.0, same_offset) == 0.0;
    // Again from there, until the residual stiffness carries next to nothing: slack fabric may have far to go.
    const bool again = round < rounds_in_place || equilibrium->kept_residual(*z, 1.0) > next_to_nothing;
    const bool kept = again && round + 1 < most_rounds && equilibrium->keep_in_place(*z, 1.0);
    if (same && !kept) return true;
    equilibrium->retract(*z, 1.0);
  }
  return false;
}

bool Simulation::Data::relax() {
  const std::optional<double> now = fade_damping(*equilibrium, stage, z, loose_solver());
  faded = now.value_or(0.0);
  energies.dissipated += faded;
  return now && finish();
}

// The undamped equilibrium. Where Newton alone does not find it, or strays so far that it may be another one, through
// damped steps from the same start.
bool Simulation::Data::come_to_rest() {
  const Vector before(*z, Teuchos::Copy);
  const std::vector<double> offsets = equilibrium->offsets();
  const State damped = state;
  const int already = tries.iterations;
  const bool found = finish();
  if (found && !strayed(damped, tries.iterations - already)) return true;
  if (!stage.damping.active) return false;
  const RCP<const Vector> end = z;
  const std::vector<double> end_offsets = equilibrium->offsets();
  z = rcp(new Vector(before, Teuchos::Copy));
  equilibrium->set_offsets(offsets);
  if (relax()) return true;
  if (!found) return false;
  z = rcp(new Vector(*end, Teuchos::Copy));
  equilibrium->set_offsets(end_offsets);
  return finish();
}

// Newton's method took many iterations from the last damped state, and went further than the last step: damping leaves
// less to go on a path of equilibria.
bool Simulation::Data::strayed(const State& damped, int taken) {
  constexpr int many = 25;
  if (!watches.damped || taken < many || progress.last_move == 0.0) return false;
  return furthest_move(damped, equilibrium->state(*z, 1.0)).distance > progress.last_move;
}

// A garment that reaches the body, or leaves it, in the stage has other null motions at its end than at its start, and
// one that went far was held by pins of another shape: a node that may not move along x is held off the body where it
// has come round it. Such a pin carries a force, so the end is solved again with those of the place and contact that
// are there.
bool Simulation::Data::conclude() {
  constexpr int most_rounds = 5;
  relaxing = true;
  watch.set_relaxing(true);
  for (int round = 0; round < most_rounds; ++round) {
    if (!come_to_rest()) return false;
    const State now = equilibrium->state(*z, 1.0);
    const std::vector<NullMotion> motions = null_motions(now, in_contact(now));
    const bool last = round + 1 == most_rounds;
    if (motions.size() == pinned.size() && (last || !pins_carry(equilibrium->balance(*z, 1.0)))) return true;
    count_linear_work();
    drive = {drive.seam_end, drive.seam_end, drive.load_end, drive.load_end};
    assemble(now, motions);
    equilibrium->start_step(*z, 1.0);
  }
  return false;
}

// A force along a motion that nothing resists would move the garment for ever: the pin must not hide it.
void Simulation::Data::check_pins() {
  const ForceBalance balance = equilibrium->balance(*z, 1.0);
  if (!pins_carry(balance)) return;
  std::string motions;
  for (const NullMotion& motion : pinned) motions += (motions.empty() ? "" : ", ") + motion.name;
  std::ostringstream message;
  message << where() << "there is no equilibrium: a force of " << balance.pin_magnitude
          << " N acts along motions of the garment that nothing resists (" << motions
          << "). Hold the garment against them by a support.";
  throw base::SolveError(message.str());
}

}  // namespace toile::solve
