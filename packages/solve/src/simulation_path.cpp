// The path of a stage to its end.
#include "simulation_data.hpp"
#include "toile/base/error.hpp"

namespace toile::solve {

bool Simulation::Data::record(const Attempt& attempt) {
  iterations += attempt.iterations;
  statistics.newton_iterations += attempt.iterations;
  attempts += attempt.s > 0.0 || statistics.steps > earlier_steps ? 1 : 0;  // not the equilibrium that it starts from
  if (!attempt.converged) {
    if (!watch.stopped().empty()) return false;
    ++cut_backs;
    ++statistics.cut_backs;
    watch.set_cut_backs(cut_backs);
    fail(attempt);
    if (stage.damping.active) stiffen_damping(*equilibrium);
    return true;
  }
  z = attempt.z;
  constexpr double round_off = 1e-12;
  if (target && target->passed(*z, attempt.s) && arrive()) return false;
  if (!target && attempt.s > 1.0 + round_off) return true;  // along the arc LOCA oversteps the end and comes back to it
  accept(attempt.s, attempt.imbalance, false);
  equilibrium->update_thickness(*z, attempt.s, 0.0);
  return true;
}

// The state between the last two steps at which the path ends, at a thickness of shells that agrees with it: the stage
// goes on at its load. False: it was not found.
bool Simulation::Data::arrive() {
  constexpr double same_thickness = 1e-7;  // mm
  constexpr int most_rounds = 30;
  std::optional<PathPoint> end = target->find();
  for (int round = 0; round < most_rounds && end; ++round) {
    if (equilibrium->update_thickness(*end->z, end->s, same_thickness) == 0.0) break;
    end = target->find_near(*end);
  }
  if (!end) return false;
  z = rcp(new Vector(*end->z, Teuchos::Copy));
  Vector f(z->getMap());
  equilibrium->residual(*z, end->s, f);
  accept(end->s, equilibrium->imbalance(f), false);
  arrived = true;
  count_linear_work();
  drive = {state.seam, state.seam, state.load, state.load};
  assemble(state, in_contact(state));
  equilibrium->start_step(*z, 1.0);
  return true;
}

void Simulation::Data::march() {
  if (stage.damping.active) choose_damping(*equilibrium, stage, z, solver());
  PathHooks hooks;
  hooks.report = [this](const Attempt& attempt) { return record(attempt); };
  if (!stage.arc_length) {
    path_watch.emplace(equilibrium, stage, options.newton);
    hooks.accepts = [this](const Vector& at, double s, int n) { return path_watch->accepts(at, s, n); };
  }
  if (stage.arc_length) {
    arc_watch.emplace(equilibrium, stage);
    hooks.accepts = [this](const Vector& at, double, int) { return arc_watch->accepts(at); };
  }
  arrived = false;
  attempts = 0;
  if (stage.until) target.emplace(problem, equilibrium, *stage.until, options.newton);
  // A damped first step is found from its start (choose_damping): the tangent of a garment that only damping holds
  // leads anywhere.
  const bool tangent_first = problem.surface == nullptr && !stage.damping.active;
  follow_path(equilibrium, stage, options.newton, tangent_first, *z, hooks);
  for (const std::string& text : {path_watch ? path_watch->warning() : "", arc_watch ? arc_watch->warning() : ""})
    if (!text.empty()) warnings.push_back(where() + text);
  if (path_watch && damped_watch && !path_watch->warning().empty()) damped_watch->leave_snaps();
  path_watch.reset();
  arc_watch.reset();
  target.reset();
  constexpr double round_off = 1e-12;
  if (arrived || (!stage.until && reached >= 1.0 - round_off))
    return;  // LOCA's status calls it a failure if the last allowed step gets there
  tell_of_damping();
  throw base::SolveError(path_failure());
}

}  // namespace toile::solve
