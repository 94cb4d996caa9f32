// The path of a stage to its end.
#include <sstream>

#include "simulation/simulation_data.hpp"
#include "toile/base/error.hpp"

namespace toile::solve {

namespace {
constexpr double end_round_off = 1e-12;
}

void Simulation::Data::count(const Attempt& attempt) {
  tries.iterations += attempt.iterations;
  statistics.newton_iterations += attempt.iterations;
}

// False: the path is given up here, or has arrived.
bool Simulation::Data::record(const Attempt& attempt) {
  count(attempt);
  if (!attempt.converged) {
    if (!watch.stopped().empty()) return false;
    ++tries.cut_backs;
    ++statistics.cut_backs;
    watch.set_cut_backs(tries.cut_backs);
    fail(attempt);
    if (stage.damping.active) stiffen_damping(*equilibrium);
    return true;
  }
  const RCP<const Vector> before = z;
  const double s_before = reached;
  const bool first = statistics.steps == progress.earlier_steps;
  z = attempt.z;
  if (target && target->passed(*z, attempt.s) && arrive()) return false;
  const StepReport report = accept(attempt.s, attempt.evaluation, false);
  if (!first) path->go_on(*before, s_before, attempt);
  publish(report);
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
  const StepReport report = accept(end->s, equilibrium->residual(*z, end->s, f), false);
  progress.phase = StagePhase::arrived;
  publish(report);
  count_linear_work();
  hold_load();
  return true;
}

// The stage goes on at the load of its state.
void Simulation::Data::hold_load() {
  drive = {state.seam, state.seam, state.load, state.load};
  assemble(state, null_motions(state, in_contact(state)));
  equilibrium->start_step(*z, 1.0);
}

void Simulation::Data::start_path() {
  AcceptsStep accepts;
  if (stage.arc_length) {
    watches.arc.emplace(equilibrium, stage);
    accepts = [this](const Vector& at, double, int) { return watches.arc->accepts(at); };
  } else {
    watches.path.emplace(equilibrium, stage, options.newton);
    accepts = [this](const Vector& at, double s, int n) { return watches.path->accepts(at, s, n); };
  }
  if (stage.until) target.emplace(problem, equilibrium, *stage.until, options.newton);
  // A damped first step is found from its start (choose_damping): the tangent of a garment that only damping holds
  // leads anywhere.
  const bool tangent_first = problem.surface == nullptr && !stage.damping.active;
  path = make_path(equilibrium, stage, options.newton, tangent_first, accepts);
}

// The equilibrium at its start. False: there is none.
bool Simulation::Data::begin_path() {
  if (stage.damping.active) choose_damping(*equilibrium, stage, z, solver());
  const Attempt first = solve_at(equilibrium, stage, options.newton, *z, 0.0);
  return record(first) && first.converged;
}

// Along the arc the load may go beyond the stage's end before it is at it.
bool Simulation::Data::oversteps(const Attempt& attempt) const {
  return !stage.until && attempt.converged && attempt.s > 1.0 + end_round_off;
}

bool Simulation::Data::took_most_steps() {
  if (path->attempts() < stage.max_steps) return false;
  std::ostringstream reason;
  reason << "it took " << path->attempts()
         << " steps (cut-backs included), its \"most steps\"; allow it more, or larger "
         << "ones (\"largest step\", now " << stage.largest_step << ")";
  watch.stop(reason.str());
  return true;
}

void Simulation::Data::follow_path() {
  while (progress.phase == StagePhase::path && (stage.until || reached < 1.0 - end_round_off)) {
    if (took_most_steps()) return;
    bool lands = path->is_at_end(reached);
    Attempt attempt = lands ? path->land(*z) : path->step(*z, reached);
    if (oversteps(attempt)) {
      count(attempt);
      if (took_most_steps()) return;
      lands = true;
      attempt = path->land(*attempt.z);
    }
    if (!record(attempt)) return;
    if (!attempt.converged && (lands || !path->shorten())) return;
  }
}

void Simulation::Data::march() {
  if (progress.phase == StagePhase::path && (statistics.steps > progress.earlier_steps || begin_path())) follow_path();
  for (const std::string& text :
       {watches.path ? watches.path->warning() : "", watches.arc ? watches.arc->warning() : ""})
    if (!text.empty()) warnings.push_back(where() + text);
  if (watches.path && watches.damped && !watches.path->warning().empty()) watches.damped->leave_snaps();
  watches.path.reset();
  watches.arc.reset();
  target.reset();
  if (progress.phase == StagePhase::arrived || (!stage.until && reached >= 1.0 - end_round_off)) return;
  tell_of_damping();
  throw base::SolveError(path_failure());
}

}  // namespace toile::solve
