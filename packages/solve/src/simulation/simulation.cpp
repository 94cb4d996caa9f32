#include "toile/solve/simulation.hpp"

#include <cblas.h>
#include <Tpetra_Core.hpp>

#include <algorithm>
#include <utility>

#include "simulation/simulation_data.hpp"
#include "toile/base/error.hpp"
#include "watch/furthest_move.hpp"

namespace toile::solve {

Simulation::Data::Data(const Problem& p, const SolverOptions& o)
    : RunSoFar(p, o, Tpetra::getDefaultComm()), StageNow(comm, o.most_time) {}

Simulation::Simulation(const Problem& problem, const SolverOptions& options)
    : data_(std::make_unique<Data>(problem, options)) {
  openblas_set_num_threads(1);  // threads inside MPI or OpenMP make the factorisation many times slower
}
Simulation::~Simulation() = default;
void Simulation::observe(Observer observer) {
  data_->observer = std::move(observer);
}
void Simulation::observe_iterations(IterationObserver observer) {
  data_->watch.observe(std::move(observer));
}
void Simulation::stop_when(std::function<std::string()> wanted) {
  data_->watch.stop_when(std::move(wanted));
}
void Simulation::set_start(const State& state) {
  data_->state = state;
}
void Simulation::set_state(const State& state) {
  data_->state = state;
  data_->started = true;
}
void Simulation::resume(const Checkpoint& from) {
  data_->resume(from);
}
Checkpoint Simulation::checkpoint() const {
  return data_->checkpoint();
}
int Simulation::stages_behind() const {
  return data_->stages.behind;
}
const State& Simulation::state() const {
  return data_->state;
}
const SolveStatistics& Simulation::statistics() const {
  return data_->statistics;
}
const std::string& Simulation::stopped() const {
  return data_->watch.stopped();
}
const std::vector<std::string>& Simulation::notes() const {
  return data_->notes.all();
}
const std::vector<std::string>& Simulation::warnings() const {
  return data_->warnings;
}

// What a stage begins with, and goes on with.
void Simulation::Data::begin() {
  released.insert(stage.released.begin(), stage.released.end());
  notes.start_stage();
  watch.start_stage(stage);
  progress = StageProgress();
  relaxing = false;
  faded = 0.0;
  watches.damped.reset();
  if (stage.damping.active) watches.damped.emplace(stage);
  progress.earlier_steps = statistics.steps;
  reached = 0.0;
}

void Simulation::Data::build() {
  progress.start = state;
  drive = stage.kind->drive(stage, progress.start);
  assemble(state, null_motions(state, near_body(problem, state)));
  equilibrium->update_thickness(*z, 0.0, 0.0);
  if (!started) equilibrium->balance_multipliers(*z, 0.0);
  started = true;
  equilibrium->start_step(*z, 0.0);
  if (stage.kind->has_path()) start_path();
}

// Of a state whose motions the `guided` clusters resist.
std::vector<NullMotion> Simulation::Data::null_motions(const State& from, const std::vector<bool>& guided) const {
  return find_null_motions(problem, from, find_held(problem, from, released), drive.seam_end >= 1.0, guided);
}

// The equations of the stage.
void Simulation::Data::assemble(const State& from, const std::vector<NullMotion>& motions) {
  tries.failed.reset();
  held = find_held(problem, from, released);
  pinned = motions;
  std::vector<std::string> pins;
  for (const NullMotion& motion : pinned) {
    HeldComponent pin;
    pin.held = true;
    pin.base = held.direction(motion.cluster, motion.component).dot(from.position[motion.cluster]);
    held.position[motion.cluster][motion.component] = pin;
    pins.push_back(where() + "nothing resists a " + motion.name + "; one component of one node is held against it");
  }
  notes.set_pins(pins);
  std::unique_ptr<LinearSolver> linear = equilibrium == nullptr ? nullptr : equilibrium->tangent().give_linear();
  equilibrium = std::make_shared<Equilibrium>(problem, from, held, drive, options, comm, std::move(linear));
  equilibrium->set_watch(&watch);
  z = equilibrium->start_vector();
  critical.start(z);
  equilibrium->tangent().seek_minimum(!stage.arc_length);
  equilibrium->set_first_step(stage.first_step);
  statistics.unknowns = static_cast<int>(equilibrium->map()->getGlobalNumElements());
  statistics.contact_nodes = equilibrium->global_contact_nodes();
  statistics.contact_stiffness = equilibrium->contact_stiffness();
}

void Simulation::Data::count_linear_work() {
  statistics.linear_iterations += equilibrium->tangent().linear().iterations();
  statistics.factorisations += equilibrium->tangent().linear().factorisations();
}

StepReport Simulation::Data::accept(double s, const Evaluation& evaluation, bool undamped) {
  const double from = reached;
  const bool moved = s > from;  // the first state, at the start of the stage, is no step
  const State before = std::exchange(state, equilibrium->state(*z, s));
  reached = s;
  StepReport report;
  report.stage = stage.name;
  report.step = ++statistics.steps;
  report.parameter = s;
  report.load = state.load;
  report.seam = state.seam;
  report.iterations = tries.iterations;
  report.cut_backs = tries.cut_backs;
  const double residual = evaluation.imbalance.relative();
  const bool damped = equilibrium->damping() > 0.0;
  report.accuracy = {residual, damped ? undamped_residual(*equilibrium, *z, s) : residual, evaluation.imbalance.gap,
                     undamped ? equilibrium->kept_residual(*z, s) : 0.0};
  StepEnergy& energy = report.energy;
  energy.strain = evaluation.strain_energy;
  energy.stabilisation = equilibrium->stabilisation_energy(*z, s);
  energies.largest = std::max(energies.largest, energy.strain);
  if (energy.stabilisation > progress.stabilised * energy.strain && energy.strain > 0.0) {
    progress.stabilised = energy.stabilisation / energy.strain;
    progress.stabilised_at = report.load;
  }
  const double now = damped ? equilibrium->dissipation(*z, s) : 0.0;
  energies.dissipated += now;
  energy.dissipated = energies.dissipated;
  energy.dissipation_ratio = energies.largest > 0.0 ? energies.dissipated / energies.largest : 0.0;
  report.balance = equilibrium->balance(*z, s);
  report.extrapolated = evaluation.extrapolated;
  report.undamped = undamped;
  bool jumped = watches.path && watches.path->accepted(*z, s);
  if (watches.arc && watches.arc->accepted(*z, s)) jumped = true;
  if (watches.damped && (moved || undamped)) {
    const double taken = undamped ? std::exchange(faded, 0.0) : now;
    if (watches.damped->accepted({before, state, from, s, taken, energies.largest})) jumped = true;
    if (moved) progress.last_move = furthest_move(before, state).distance;
  }
  equilibrium->end_step(*z, s);
  equilibrium->start_step(*z, s);
  if (undamped || stage.stability_every_step) {
    count_pivots(s, report);
    watch_ellipticity(report);
  }
  if (jumped) report.critical = CriticalPoint::jump;
  if (damped && moved)
    adapt_damping(*equilibrium, stage.damping, energies.largest, energy.strain - energies.last, now, tries.iterations);
  energies.last = energy.strain;
  report.seconds = clock.seconds();
  tries.iterations = tries.cut_backs = 0;
  watch.set_cut_backs(0);
  equilibrium->tangent().renew();  // the next step depends on its start alone
  return report;
}

// The run can be resumed from here.
void Simulation::Data::publish(const StepReport& report) {
  reports.push_back(report);
  if (observer) observer(report, state);
}

void Simulation::Data::count_pivots(double s, StepReport& report) {
  const std::string passed = critical.count(*equilibrium, *z, s, stage.arc_length, report);
  if (!passed.empty()) notes.add(where() + passed);
}

bool Simulation::Data::solve(double s, double least_tolerance) {
  NewtonOptions newton = options.newton;
  newton.tolerance = std::max(newton.tolerance, least_tolerance);
  newton.to_rest = relaxing && equilibrium->damping() == 0.0;
  const Attempt attempt = solve_at(equilibrium, stage, newton, *z, s);
  tries.iterations += attempt.iterations;
  statistics.newton_iterations += attempt.iterations;
  if (attempt.converged)
    z = attempt.z;
  else
    fail(attempt);
  return attempt.converged;
}

void Simulation::Data::fail(const Attempt& attempt) {
  tries.failed = attempt;
  tries.failed_damping = equilibrium->damping();
}

void Simulation::run(const StageOptions& stage) {
  if (stage.kind == nullptr)
    throw base::Error(base::ExitCode::internal_error, "stage \"" + stage.name + "\" is of no kind");
  Data& d = *data_;
  if (d.stages.run++ < d.stages.behind) return;
  d.stage = stage;
  if (d.resumed) {
    d.rebuild(*d.resumed);
    d.resumed.reset();
  } else {
    d.begin();
    d.build();
  }
  if (stage.kind->has_path()) d.march();
  if (!d.conclude()) throw base::SolveError(d.end_failure());
  d.check_pins();
  Vector f(d.z->getMap());
  const StepReport last = d.accept(1.0, d.equilibrium->residual(*d.z, 1.0, f), true);
  d.judge(last);
  d.count_linear_work();
  d.progress.phase = StagePhase::finished;
  d.publish(last);
}

}  // namespace toile::solve
