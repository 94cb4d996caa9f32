// Going on after an accepted step.
#include "simulation/simulation_data.hpp"
#include "toile/base/error.hpp"

namespace toile::solve {

Checkpoint Simulation::Data::checkpoint() const {
  if (reports.empty()) throw base::Error(base::ExitCode::internal_error, "a run without a step has no checkpoint");
  Checkpoint c;
  c.stage.index = stages.run - 1;
  c.stage.name = stage.name;
  c.state = state;
  c.released = released;
  c.energies = energies;
  c.stage.progress.phase = progress.phase;
  c.seconds = clock.seconds();
  c.statistics = statistics;
  c.notes = notes.memory();
  c.warnings = warnings;
  c.reports = reports;
  if (progress.phase == StagePhase::finished) return c;
  c.stage.progress = progress;
  c.stage.iterations = watch.iterations();
  for (const NullMotion& motion : pinned) c.pins.push_back({motion.name, motion.cluster, motion.component});
  c.statistics.linear_iterations += equilibrium->tangent().linear().iterations();
  c.statistics.factorisations += equilibrium->tangent().linear().factorisations();
  c.equilibrium = equilibrium->memory(*z);
  c.pivots = critical.memory(*equilibrium);
  c.path = path->memory();
  if (watches.damped) c.watches.damped = watches.damped->memory();
  if (watches.path) c.watches.path = watches.path->memory();
  if (watches.arc) c.watches.arc = watches.arc->memory();
  if (target) c.target = target->memory();
  return c;
}

void Simulation::Data::resume(const Checkpoint& from) {
  if (from.state.position.size() != problem.clusters.size() || from.state.frame.size() != state.frame.size())
    throw base::InputError("the checkpoint is of another garment: it has " +
                           std::to_string(from.state.position.size()) + " places that move on their own, not " +
                           std::to_string(problem.clusters.size()));
  state = from.state;
  stage.name = from.stage.name;
  progress.phase = from.stage.progress.phase;
  started = true;
  released = from.released;
  energies = from.energies;
  statistics = from.statistics;
  notes.resume(from.notes);
  warnings = from.warnings;
  reports = from.reports;
  clock.earlier = from.seconds;
  stages.behind = from.stage.index + (from.stage.progress.phase == StagePhase::finished ? 1 : 0);
  if (from.stage.progress.phase != StagePhase::finished) resumed = from;
}

// The stage as it was after the step, with the same bits.
void Simulation::Data::rebuild(const Checkpoint& from) {
  if (stage.name != from.stage.name)
    throw base::InputError("the checkpoint is of stage \"" + from.stage.name + "\", which is \"" + stage.name +
                           "\" here");
  begin();
  progress = from.stage.progress;
  watch.set_iterations(from.stage.iterations);
  if (watches.damped && from.watches.damped) watches.damped->resume(*from.watches.damped);
  drive = stage.kind->drive(stage, progress.start);
  std::vector<NullMotion> motions;
  for (const Pin& pin : from.pins) motions.push_back({pin.motion, pin.cluster, pin.component});
  assemble(progress.start, motions);
  notes.resume(from.notes);
  z = equilibrium->resume(from.equilibrium);
  reached = from.equilibrium.s;
  critical.resume(from.pivots, *equilibrium);
  start_path();
  path->resume(from.path);
  if (watches.path && from.watches.path) watches.path->resume(*from.watches.path);
  if (watches.arc && from.watches.arc) watches.arc->resume(*from.watches.arc);
  if (target && from.target) target->resume(*from.target);
  if (progress.phase == StagePhase::arrived)
    hold_load();
  else
    equilibrium->update_thickness(*z, reached, 0.0);
}

}  // namespace toile::solve
