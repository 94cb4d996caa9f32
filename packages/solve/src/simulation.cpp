#include "toile/solve/simulation.hpp"

#include <cblas.h>
#include <Tpetra_Core.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

#include "continuation.hpp"
#include "critical_points.hpp"
#include "damping.hpp"
#include "diagnosis.hpp"
#include "fabric_state.hpp"
#include "held.hpp"
#include "notes.hpp"
#include "null_motion.hpp"
#include "path_target.hpp"
#include "path_watch.hpp"
#include "toile/base/error.hpp"
#include "toile/solve/loss_of_ellipticity.hpp"
#include "watch.hpp"

namespace toile::solve {

struct Simulation::Data {
  const Problem& problem;
  SolverOptions options;
  RCP<const Comm> comm;
  Observer observer;
  State state;
  SolveStatistics statistics;
  Notes notes;
  std::vector<std::string> warnings;
  std::set<std::string> released;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  bool started = false;
  double largest_energy = 0.0, last_energy = 0.0, dissipated = 0.0;

  // Of the stage that runs.
  StageOptions stage;
  Drive drive;
  Watch watch;
  State stage_start;
  Held held;
  bool relaxing = false;
  std::shared_ptr<Equilibrium> equilibrium;
  RCP<Vector> z;
  std::vector<NullMotion> pinned;
  int earlier_steps = 0;
  int iterations = 0, cut_backs = 0;
  double reached = 0.0;  ///< s of the last accepted step
  CriticalPoints critical;
  std::optional<PathWatch> path_watch;  ///< of a path that can be left unseen: step by step in the load, undamped
  std::optional<TargetSearch> target;   ///< of a path that ends elsewhere than at its load
  bool arrived = false;                 ///< there
  int attempts = 0;                     ///< steps of the path, cut-backs included
  double stabilised = 0.0, stabilised_at = 0.0;  ///< largest share of the energy that only stabilises, and its load
  bool lost_ellipticity = false;
  std::optional<Attempt> failed;  ///< the last one
  double failed_damping = 0.0;

  Data(const Problem& p, const SolverOptions& o)
      : problem(p), options(o), comm(Tpetra::getDefaultComm()), state(placed_state(p)), watch(comm, o.most_time) {}

  void build();
  void assemble(const State& from, const std::vector<bool>& guided);
  StepReport accept(double s, const Imbalance& imbalance, bool undamped);
  bool solve(double s);
  bool finish();
  bool relax();
  bool come_to_rest();
  bool conclude();
  void check_pins();
  void count_linear_work();
  void fail(const Attempt& attempt);
  std::string diagnosis();
  std::string path_failure();
  std::string end_failure();
  void watch_ellipticity(const StepReport& report);
  void judge(const StepReport& last);
  bool is_slack_membrane() const;
  void march();
  SolveAt solver() {
    return [this](double s) -> std::optional<int> {
      const int before = iterations;
      if (!solve(s)) return std::nullopt;
      return iterations - before;
    };
  }
  std::string where() const { return "stage \"" + stage.name + "\": "; }
  void count_pivots(double s, StepReport& report);
  bool record(const Attempt& attempt);
  bool arrive();
};

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
const State& Simulation::state() const {
  return data_->state;
}
const SolveStatistics& Simulation::statistics() const {
  return data_->statistics;
}
const std::vector<std::string>& Simulation::notes() const {
  return data_->notes.all();
}
const std::vector<std::string>& Simulation::warnings() const {
  return data_->warnings;
}

void Simulation::Data::build() {
  released.insert(stage.released.begin(), stage.released.end());
  drive = {state.seam, state.seam, state.load, state.load};
  if (stage.type == StageType::sew) drive.seam_end = stage.target;
  if (stage.type == StageType::load) drive.load_end = stage.target;
  notes.start_stage();
  watch.start_stage(stage);
  stage_start = state;
  relaxing = false;
  lost_ellipticity = false;
  stabilised = 0.0;
  earlier_steps = statistics.steps;
  assemble(state, near_body(problem, state));
  equilibrium->update_thickness(*z, 0.0, 0.0);
  if (!started) equilibrium->balance_multipliers(*z, 0.0);
  started = true;
  reached = 0.0;
  equilibrium->start_step(*z, 0.0);
}

// The equations of the stage, from a state whose motions the `guided` clusters resist.
void Simulation::Data::assemble(const State& from, const std::vector<bool>& guided) {
  failed.reset();
  held = find_held(problem, from, released);
  pinned = find_null_motions(problem, from, held, drive.seam_end >= 1.0, guided);
  std::vector<std::string> pins;
  for (const NullMotion& motion : pinned) {
    HeldComponent pin;
    pin.held = true;
    pin.base = held.direction(motion.cluster, motion.component).dot(from.position[motion.cluster]);
    held.position[motion.cluster][motion.component] = pin;
    pins.push_back(where() + "nothing resists a " + motion.name + "; one component of one node is held against it");
  }
  notes.set_pins(pins);
  equilibrium = std::make_shared<Equilibrium>(problem, from, held, drive, options, comm);
  equilibrium->set_watch(&watch);
  z = equilibrium->start_vector();
  critical.start(z);
  equilibrium->seek_minimum(!stage.arc_length);
  equilibrium->set_first_step(stage.first_step);
  statistics.unknowns = static_cast<int>(equilibrium->map()->getGlobalNumElements());
  statistics.contact_nodes = equilibrium->global_contact_nodes();
  statistics.contact_stiffness = equilibrium->contact_stiffness();
}

void Simulation::Data::count_linear_work() {
  statistics.linear_iterations += equilibrium->linear().iterations();
  statistics.factorisations += equilibrium->linear().factorisations();
}

StepReport Simulation::Data::accept(double s, const Imbalance& imbalance, bool undamped) {
  const bool moved = s > reached;  // the first state, at the start of the stage, is no step
  state = equilibrium->state(*z, s);
  reached = s;
  StepReport report;
  report.stage = stage.name;
  report.step = ++statistics.steps;
  report.parameter = s;
  report.load = state.load;
  report.seam = state.seam;
  report.iterations = iterations;
  report.cut_backs = cut_backs;
  report.residual = imbalance.relative();
  report.undamped_residual = undamped_residual(*equilibrium, *z, s);
  report.gap = imbalance.gap;
  report.strain_energy = equilibrium->strain_energy();
  report.stabilisation_energy = equilibrium->stabilisation_energy(*z, s);
  largest_energy = std::max(largest_energy, report.strain_energy);
  if (report.stabilisation_energy > stabilised * report.strain_energy && report.strain_energy > 0.0) {
    stabilised = report.stabilisation_energy / report.strain_energy;
    stabilised_at = report.load;
  }
  const double now = equilibrium->damping() > 0.0 ? equilibrium->dissipation(*z, s) : 0.0;
  dissipated += now;
  report.dissipated = dissipated;
  report.dissipation_ratio = largest_energy > 0.0 ? dissipated / largest_energy : 0.0;
  report.balance = equilibrium->balance(*z, s);
  report.extrapolated = equilibrium->extrapolated();
  report.undamped = undamped;
  const bool jumped = path_watch && path_watch->accepted(*z, s);
  equilibrium->start_step(*z, s);
  if (undamped || stage.stability_every_step) {
    count_pivots(s, report);
    watch_ellipticity(report);
  }
  if (jumped) report.critical = CriticalPoint::jump;
  if (equilibrium->damping() > 0.0 && moved)
    adapt_damping(*equilibrium, stage.damping, largest_energy, report.strain_energy - last_energy, now, iterations);
  last_energy = report.strain_energy;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  iterations = cut_backs = 0;
  watch.set_cut_backs(0);
  if (observer) observer(report, state);
  return report;
}

void Simulation::Data::count_pivots(double s, StepReport& report) {
  const std::string passed = critical.count(*equilibrium, *z, s, stage.arc_length, report);
  if (!passed.empty()) notes.add(where() + passed);
}

bool Simulation::Data::solve(double s) {
  const Attempt attempt = solve_at(equilibrium, stage, options.newton, *z, s);
  iterations += attempt.iterations;
  statistics.newton_iterations += attempt.iterations;
  if (attempt.converged)
    z = attempt.z;
  else
    fail(attempt);
  return attempt.converged;
}

void Simulation::Data::fail(const Attempt& attempt) {
  failed = attempt;
  failed_damping = equilibrium->damping();
}

// The undamped equilibrium at fixed load, with the contact offset iterated until it agrees with the thickness.
bool Simulation::Data::finish() {
  constexpr double same_offset = 1e-7;  // mm
  constexpr int most_rounds = 30;
  equilibrium->set_damping(0.0);
  for (int round = 0; round < most_rounds; ++round) {
    if (!solve(1.0)) return false;
    if (equilibrium->update_thickness(*z, 1.0, same_offset) == 0.0) return true;
    equilibrium->retract(*z, 1.0);
  }
  return false;
}

bool Simulation::Data::relax() {
  const std::optional<double> now = fade_damping(*equilibrium, stage, z, solver());
  dissipated += now.value_or(0.0);
  return now && finish();
}

// The undamped equilibrium; where Newton alone does not find it, through damped steps from the same start.
bool Simulation::Data::come_to_rest() {
  const Vector before(*z, Teuchos::Copy);
  const std::vector<double> offsets = equilibrium->offsets();
  if (finish()) return true;
  if (!stage.damping.active) return false;
  z = rcp(new Vector(before, Teuchos::Copy));
  equilibrium->set_offsets(offsets);
  return relax();
}

// A garment that reaches the body, or leaves it, in the stage has other null motions at its end than at its start. A
// pin that is not needed any more would carry a force, so the end is solved again with those of the contact that is
// there.
bool Simulation::Data::conclude() {
  constexpr int most_rounds = 5;
  relaxing = true;
  watch.set_relaxing(true);
  for (int round = 0; round < most_rounds; ++round) {
    if (!come_to_rest()) return false;
    const State now = equilibrium->state(*z, 1.0);
    const std::vector<bool> guided = in_contact(now);
    if (find_null_motions(problem, now, find_held(problem, now, released), drive.seam_end >= 1.0, guided).size() ==
        pinned.size())
      return true;
    count_linear_work();
    drive = {drive.seam_end, drive.seam_end, drive.load_end, drive.load_end};
    assemble(now, guided);
    equilibrium->start_step(*z, 1.0);
  }
  return false;
}

// A force along a motion that nothing resists would move the garment for ever: the pin must not hide it.
void Simulation::Data::check_pins() {
  constexpr double allowed = 1e-6;
  const ForceBalance balance = equilibrium->balance(*z, 1.0);
  if (balance.pin_magnitude <= allowed * balance.magnitude) return;
  std::string motions;
  for (const NullMotion& motion : pinned) motions += (motions.empty() ? "" : ", ") + motion.name;
  std::ostringstream message;
  message << where() << "there is no equilibrium: a force of " << balance.pin_magnitude
          << " N acts along motions of the garment that nothing resists (" << motions
          << "). Hold the garment against them by a support.";
  throw base::SolveError(message.str());
}

// A step that is looked at for its stability is looked at for the material's too.
void Simulation::Data::watch_ellipticity(const StepReport& report) {
  if (!report.undamped && lost_ellipticity) return;
  const LossOfEllipticity loss = find_loss_of_ellipticity(problem, state);
  if (!loss.found()) return;
  if (report.undamped)
    warnings.push_back(where() + "in its final state " + loss.text());
  else
    notes.add(where() + "at load " + std::to_string(report.load) + " " + loss.text());
  lost_ellipticity = true;
}

// What did not converge where the last attempt gave up, and why. Collective.
std::string Simulation::Data::diagnosis() {
  if (!watch.stopped().empty() || !failed) return {};
  const Remainder left = remainder_of(*equilibrium, *failed, failed_damping, problem.clusters.size());
  const Failure failure{
      problem,  stage,    options.newton, held, stage_start, state, left, reached, statistics.steps > earlier_steps,
      relaxing, cut_backs};
  const std::string cause = likely_cause(failure);
  return " " + what_failed(failure) + (cause.empty() ? "" : " Likely cause: " + cause + ".");
}

std::string Simulation::Data::end_failure() {
  std::string text = where() + "no undamped equilibrium was found at its end";
  if (!watch.stopped().empty()) text += ", because " + watch.stopped();
  if (statistics.steps > earlier_steps)
    text += std::string("; the last converged ") + (stage.damping.active ? "(damped) " : "") +
            "state was kept, and its pressures must not be read as final.";
  else
    text += ", and no step of it was accepted.";
  return text + diagnosis();
}

// Then the signs of the pivots are those of round-off.
bool Simulation::Data::is_slack_membrane() const {
  const bool shells =
      std::all_of(problem.laws.begin(), problem.laws.end(), [](const BlockLaw& law) { return law.is_shell(); });
  return !shells && fabric_state(problem, state).is_slack();
}

void Simulation::Data::judge(const StepReport& last) {
  const std::string unstable = stability_warning(last);
  if (!unstable.empty() && is_slack_membrane())
    notes.add(where() +
              "its fabric carries no tension at its end. A membrane without tension resists no motion across itself: "
              "what is written is one of the shapes that it may hang in");
  else if (!unstable.empty())
    warnings.push_back(where() + unstable);
  constexpr double most_stabilised = 0.05;
  if (stabilised > most_stabilised) {
    std::ostringstream text;
    text.precision(3);
    text << "up to " << 100.0 * stabilised << " % of the strain energy (at load " << stabilised_at
         << ") is that of the hourglass modes of reduced shells, which bends what the mesh cannot follow: it is too "
            "coarse "
            "there, and may snap early or be too soft or too stiff. Take more elements";
    warnings.push_back(where() + text.str());
  }
  if (stage.damping.active && dissipated > stage.damping.limit * largest_energy)
    warnings.push_back(where() +
                       "the damping dissipated more than the limit; its path was not quasi-static (the final state is "
                       "undamped)");
}

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
  if (!stage.damping.active && !stage.arc_length) {
    path_watch.emplace(equilibrium, stage, options.newton);
    hooks.accepts = [this](const Vector& at, double s, int n) { return path_watch->accepts(at, s, n); };
  }
  arrived = false;
  attempts = 0;
  if (stage.until) target.emplace(problem, equilibrium, *stage.until, options.newton);
  // A damped first step is found from its start (choose_damping): the tangent of a garment that only damping holds
  // leads anywhere.
  const bool tangent_first = problem.surface == nullptr && !stage.damping.active;
  follow_path(equilibrium, stage, options.newton, tangent_first, *z, hooks);
  if (path_watch && !path_watch->warning().empty()) warnings.push_back(where() + path_watch->warning());
  path_watch.reset();
  target.reset();
  constexpr double round_off = 1e-12;
  if (arrived || (!stage.until && reached >= 1.0 - round_off))
    return;  // LOCA's status calls it a failure if the last allowed step gets there
  throw base::SolveError(path_failure());
}

std::string Simulation::Data::path_failure() {
  std::ostringstream message;
  message << "stage \"" << stage.name << "\" could not reach its end: it stopped at ";
  if (stage.type == StageType::sew)
    message << state.seam * 100.0 << " % of the seams' closing";
  else
    message << "load " << state.load << (stage.arc_length ? " on its path, target " : " of ") << stage.target;
  if (stage.until) message << " (and before \"Until\" " << stage.until->value << " on " << stage.until->on << ")";
  if (!watch.stopped().empty()) {
    message << ", because " << watch.stopped() << ".";
    return message.str();
  }
  if (statistics.steps == earlier_steps) {
    message << ", and no step of it was accepted.";
  } else if (attempts >= stage.max_steps || cut_backs == 0) {
    message << ", after " << attempts
            << " steps (cut-backs included), its \"most steps\". Allow it more, or larger ones (\"largest "
            << "step\", now " << stage.largest_step << ").";
    return message.str();
  } else {
    message << ", after " << cut_backs << " cut-backs at that point (\"smallest step\" " << stage.smallest_step << ").";
  }
  return message.str() + diagnosis();
}

void Simulation::run(const StageOptions& stage) {
  Data& d = *data_;
  d.stage = stage;
  d.build();
  if (stage.type != StageType::settle) d.march();
  if (!d.conclude()) throw base::SolveError(d.end_failure());
  d.check_pins();
  Vector f(d.z->getMap());
  d.equilibrium->residual(*d.z, 1.0, f);
  d.judge(d.accept(1.0, d.equilibrium->imbalance(f), true));
  d.count_linear_work();
}

}  // namespace toile::solve
