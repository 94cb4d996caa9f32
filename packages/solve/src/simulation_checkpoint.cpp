// Going on after an accepted step.
#include "simulation_data.hpp"
#include "toile/base/error.hpp"

namespace toile::solve {

Checkpoint Simulation::Data::checkpoint() const {
  if (reports.empty()) throw base::Error(base::ExitCode::internal_error, "a run without a step has no checkpoint");
  Checkpoint c;
  c.stage = stages_run - 1;
  c.stage_name = stage.name;
  c.phase = phase;
  c.state = state;
  c.released = released;
  c.largest_energy = largest_energy;
  c.last_energy = last_energy;
  c.dissipated = dissipated;
  c.seconds = seconds();
  c.statistics = statistics;
  c.notes = notes.all();
  c.first_pin_note = notes.first_pin();
  c.pin_notes = notes.pins();
  c.warnings = warnings;
  c.reports = reports;
  if (phase == StagePhase::finished) return c;
  c.last_move = last_move;
  c.stabilised = stabilised;
  c.stabilised_at = stabilised_at;
  c.lost_ellipticity = lost_ellipticity;
  c.earlier_steps = earlier_steps;
  c.stage_iterations = watch.iterations();
  c.stage_start = stage_start;
  for (const NullMotion& motion : pinned) c.pins.push_back({motion.name, motion.cluster, motion.component});
  c.statistics.linear_iterations += equilibrium->linear().iterations();
  c.statistics.factorisations += equilibrium->linear().factorisations();
  c.equilibrium = equilibrium->memory(*z);
  c.pivots = critical.memory(*equilibrium);
  c.path = path->memory();
  if (damped_watch) c.damped_watch = damped_watch->memory();
  if (path_watch) c.path_watch = path_watch->memory();
  if (arc_watch) c.arc_watch = arc_watch->memory();
  if (target) c.target = target->memory();
  return c;
}

void Simulation::Data::resume(const Checkpoint& from) {
  if (from.state.position.size() != problem.clusters.size() || from.state.frame.size() != state.frame.size())
    throw base::InputError("the checkpoint is of another garment: it has " +
                           std::to_string(from.state.position.size()) + " places that move on their own, not " +
                           std::to_string(problem.clusters.size()));
  state = from.state;
  stage.name = from.stage_name;
  phase = from.phase;
  started = true;
  released = from.released;
  largest_energy = from.largest_energy;
  last_energy = from.last_energy;
  dissipated = from.dissipated;
  statistics = from.statistics;
  notes.resume(from.notes, from.first_pin_note, from.pin_notes);
  warnings = from.warnings;
  reports = from.reports;
  earlier_seconds = from.seconds;
  stages_behind = from.stage + (from.phase == StagePhase::finished ? 1 : 0);
  if (from.phase != StagePhase::finished) resumed = from;
}

// The stage as it was after the step, with the same bits.
void Simulation::Data::rebuild(const Checkpoint& from) {
  if (stage.name != from.stage_name)
    throw base::InputError("the checkpoint is of stage \"" + from.stage_name + "\", which is \"" + stage.name +
                           "\" here");
  begin();
  phase = from.phase;
  stage_start = from.stage_start;
  earlier_steps = from.earlier_steps;
  lost_ellipticity = from.lost_ellipticity;
  stabilised = from.stabilised;
  stabilised_at = from.stabilised_at;
  last_move = from.last_move;
  watch.set_iterations(from.stage_iterations);
  if (damped_watch && from.damped_watch) damped_watch->resume(*from.damped_watch);
  drive = stage.kind->drive(stage, stage_start);
  std::vector<NullMotion> motions;
  for (const Pin& pin : from.pins) motions.push_back({pin.motion, pin.cluster, pin.component});
  assemble(stage_start, motions);
  notes.resume(from.notes, from.first_pin_note, from.pin_notes);
  z = equilibrium->resume(from.equilibrium);
  reached = from.equilibrium.s;
  critical.resume(from.pivots, *equilibrium);
  start_path();
  path->resume(from.path);
  if (path_watch && from.path_watch) path_watch->resume(*from.path_watch);
  if (arc_watch && from.arc_watch) arc_watch->resume(*from.arc_watch);
  if (target && from.target) target->resume(*from.target);
  if (phase == StagePhase::arrived)
    hold_load();
  else
    equilibrium->update_thickness(*z, reached, 0.0);
}

}  // namespace toile::solve
