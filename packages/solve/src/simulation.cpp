#include "toile/solve/simulation.hpp"

#include <LOCA_GlobalData.H>
#include <LOCA_Parameter_SublistParser.H>
#include <LOCA_Stepper.H>
#include <NOX_Solver_Factory.H>
#include <cblas.h>
#include <Tpetra_Core.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <sstream>

#include "equilibrium_group.hpp"
#include "newton.hpp"
#include "null_motion.hpp"
#include "toile/base/error.hpp"

namespace toile::solve {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::array<HeldComponent, 3>> held_positions(const Problem& problem,
                                                         const std::set<std::string>& released) {
  std::vector<int> cluster_of(problem.mesh->nodes());
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  std::vector<std::array<HeldComponent, 3>> held(problem.clusters.size());
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const Support& support = problem.supports[s];
    if (released.count(support.name)) continue;
    for (const int node : support.nodes)
      for (int i = 0; i < 3; ++i) {
        if (!support.held[i]) continue;
        HeldComponent& h = held[cluster_of[node]][i];
        if (h.held && h.displacement != support.displacement[i])
          throw base::InputError("supports contradict each other: support \"" + support.name + "\" moves node " +
                                 std::to_string(node) + " by " + std::to_string(support.displacement[i]) +
                                 " mm in direction " + "xyz"[i] + ", another support by " +
                                 std::to_string(h.displacement) + " mm");
        h = {true, problem.mesh->placed[problem.clusters[cluster_of[node]].front()][i], support.displacement[i],
             static_cast<int>(s)};
      }
  }
  return held;
}

/// Whether a support holds the rotation that moves a director along `tangent`, the first of which start_frame laid
/// along the normal of the plane that the director stays in.
bool holds(const Problem& problem, const Support& support, int node, const Vec3& tangent) {
  constexpr double along = 0.9;
  switch (support.director) {
    case DirectorSupport::free:
      return false;
    case DirectorSupport::held:
      return true;
    case DirectorSupport::symmetry:
      for (Eigen::Index d = 0; d < 3; ++d)
        if (support.held[static_cast<size_t>(d)] && std::abs(tangent[d]) > along) return true;
      return false;
    case DirectorSupport::diaphragm:
      return std::abs(tangent.dot(diaphragm_normal(problem, support, node).normalized())) > along;
  }
  return false;
}

/// Which rotations the supports hold: all of a clamp, and those out of a plane of symmetry or of a diaphragm.
std::vector<std::array<bool, 2>> held_rotations(const Problem& problem, const State& state,
                                                const std::set<std::string>& released) {
  if (state.frame.empty()) return {};
  std::vector<std::array<bool, 2>> held;
  for (const bool is_shell : shell_nodes(problem)) held.push_back({!is_shell, !is_shell});
  for (const Support& support : problem.supports) {
    if (released.count(support.name)) continue;
    for (const int node : support.nodes)
      for (Eigen::Index k = 0; k < 2; ++k)
        if (holds(problem, support, node, state.frame[node].row(k))) held[node][static_cast<size_t>(k)] = true;
  }
  return held;
}

}  // namespace

struct Simulation::Data {
  const Problem& problem;
  SolverOptions options;
  RCP<const Comm> comm;
  Observer observer;
  State state;
  SolveStatistics statistics;
  std::vector<std::string> notes, warnings;
  std::set<std::string> released;
  Clock::time_point start = Clock::now();
  bool started = false;
  double largest_energy = 0.0, dissipated = 0.0;

  // Of the stage that runs.
  StageOptions stage;
  Drive drive;
  std::shared_ptr<Equilibrium> equilibrium;
  RCP<Vector> z;
  std::vector<NullMotion> pinned;
  size_t earlier_notes = 0;  ///< of the stages before
  int earlier_steps = 0;
  int iterations = 0, cut_backs = 0;
  double reached = 0.0;  ///< s of the last accepted step
  // Of the last step whose negative pivots were counted.
  int pivots = -1;
  double pivots_load = 0.0, last_direction = 1.0, s_counted = 0.0;
  RCP<Vector> z_counted;

  Data(const Problem& p, const SolverOptions& o)
      : problem(p), options(o), comm(Tpetra::getDefaultComm()), state(placed_state(p)) {}

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
  std::string failure() const;
  void judge(const StepReport& last);
  void march();
  double fallback_damping() const;
  void choose_damping();
  double undamped_residual(double s);
  LineSearch line_search() const { return stage.arc_length ? LineSearch::none : LineSearch::energy; }
  void count_pivots(double s, StepReport& report);
  void adapt_damping(double dissipated_now);
  void run_stepper();
};

Simulation::Simulation(const Problem& problem, const SolverOptions& options)
    : data_(std::make_unique<Data>(problem, options)) {
  openblas_set_num_threads(1);  // threads inside MPI or OpenMP make the factorisation many times slower
}
Simulation::~Simulation() = default;
void Simulation::observe(Observer observer) {
  data_->observer = std::move(observer);
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
  return data_->notes;
}
const std::vector<std::string>& Simulation::warnings() const {
  return data_->warnings;
}

void Simulation::Data::build() {
  released.insert(stage.released.begin(), stage.released.end());
  drive = {state.seam, state.seam, state.load, state.load};
  if (stage.type == StageType::sew) drive.seam_end = stage.target;
  if (stage.type == StageType::load) drive.load_end = stage.target;
  earlier_notes = notes.size();
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
  Held held{held_positions(problem, released), held_rotations(problem, from, released)};
  pinned = find_null_motions(problem, from, held, drive.seam_end >= 1.0, guided);
  notes.resize(earlier_notes);
  for (const NullMotion& motion : pinned) {
    held.position[motion.cluster][motion.component] = {true, from.position[motion.cluster][motion.component], 0.0, -1};
    notes.push_back("stage \"" + stage.name + "\": nothing resists a " + motion.name +
                    "; one component of one node is held against it");
  }
  equilibrium = std::make_shared<Equilibrium>(problem, from, held, drive, options, comm);
  z = equilibrium->start_vector();
  pivots = -1;
  last_direction = 1.0;
  s_counted = 0.0;
  z_counted = z;
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

// Where there is no energy to measure (flat, floating panels), the damping diagonal is 1e-4 of the mean tangent
// diagonal (DESIGN "Stabilisation").
double Simulation::Data::fallback_damping() const {
  return 1e-4 * std::abs(equilibrium->mean_tangent_diagonal()) / equilibrium->mean_mass() * stage.first_step;
}

// The damping with which the first step dissipates the wanted share of its strain energy, found by trying that step: a
// softer one moves further, so it is tried again.
void Simulation::Data::choose_damping() {
  constexpr int rounds = 3;
  constexpr double next_to_nothing = 1e-12;  // of stiffness times step squared
  equilibrium->set_damping(fallback_damping());
  const RCP<Vector> before = z;
  bool converged = solve(0.0);
  const RCP<Vector> first = z;
  equilibrium->start_step(*first, 0.0);
  for (int round = 0; round < rounds && converged; ++round) {
    z = first;
    converged = solve(stage.first_step);
    const double now = equilibrium->dissipation(*z, stage.first_step), c = equilibrium->damping();
    const double step_squared = now * stage.first_step / (c * equilibrium->mean_mass());
    const double energy = equilibrium->strain_energy(), wanted = stage.damping.fraction * energy;
    const double least = next_to_nothing * std::abs(equilibrium->mean_tangent_diagonal()) * step_squared;
    if (!converged || now <= 0.0 || energy <= least || std::abs(std::log2(wanted / now)) < 1.0) break;
    equilibrium->set_damping(c * wanted / now);
  }
  z = before;
  equilibrium->start_step(*z, 0.0);
}

void Simulation::Data::adapt_damping(double now) {
  const double wanted = stage.damping.fraction * largest_energy;
  if (now <= 0.0 || wanted <= 0.0) return;
  equilibrium->set_damping(equilibrium->damping() * std::clamp(wanted / now, 0.2, 5.0));
}

double Simulation::Data::undamped_residual(double s) {
  const double damping = equilibrium->damping();
  equilibrium->set_damping(0.0);
  Vector f(z->getMap());
  equilibrium->residual(*z, s, f);
  equilibrium->set_damping(damping);
  return equilibrium->imbalance(f).relative();
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
  report.undamped_residual = undamped_residual(s);
  report.gap = imbalance.gap;
  report.strain_energy = equilibrium->strain_energy();
  largest_energy = std::max(largest_energy, report.strain_energy);
  const double now = equilibrium->damping() > 0.0 ? equilibrium->dissipation(*z, s) : 0.0;
  dissipated += now;
  report.dissipated = dissipated;
  report.dissipation_ratio = largest_energy > 0.0 ? dissipated / largest_energy : 0.0;
  report.balance = equilibrium->balance(*z, s);
  report.extrapolated = equilibrium->extrapolated();
  report.undamped = undamped;
  equilibrium->start_step(*z, s);
  if (undamped || stage.stability_every_step) count_pivots(s, report);
  if (equilibrium->damping() > 0.0 && moved) adapt_damping(now);
  report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  iterations = cut_backs = 0;
  if (observer) observer(report, state);
  return report;
}

// The tangent without damping tells stable from unstable; a change between two steps tells what was passed.
void Simulation::Data::count_pivots(double s, StepReport& report) {
  const double damping = equilibrium->damping();
  equilibrium->set_damping(0.0);
  equilibrium->start_step(*z, s);
  double direction = 1.0;
  if (stage.arc_length) {
    Vector step(*z, Teuchos::Copy);
    step.update(-1.0, *z_counted, 1.0);
    direction = equilibrium->path_direction(*z, s, step, s - s_counted);
  } else {
    equilibrium->linearise(*z, s);
  }
  equilibrium->set_damping(damping);
  report.negative_pivots = equilibrium->unshifted_negative_pivots();
  if (pivots >= 0 && report.negative_pivots >= 0 && report.negative_pivots != pivots) {
    report.critical = !stage.arc_length                  ? CriticalPoint::unclassified
                      : direction * last_direction < 0.0 ? CriticalPoint::limit
                                                         : CriticalPoint::bifurcation;
    std::ostringstream note;
    note << "stage \"" << stage.name << "\": "
         << (report.critical == CriticalPoint::limit         ? "a limit point"
             : report.critical == CriticalPoint::bifurcation ? "a bifurcation"
                                                             : "a limit point, a bifurcation or a change of contact")
         << " was passed between load " << pivots_load << " and " << report.load << " (negative pivots " << pivots
         << " -> " << report.negative_pivots << ")";
    notes.push_back(note.str());
  }
  last_direction = direction;
  pivots = report.negative_pivots;
  pivots_load = report.load;
  s_counted = s;
  z_counted = rcp(new Vector(*z, Teuchos::Copy));
}

bool Simulation::Data::solve(double s) {
  const RCP<Teuchos::ParameterList> top = Teuchos::parameterList();
  top->sublist("NOX") = *newton_parameters(line_search());
  const RCP<LOCA::GlobalData> global = LOCA::createGlobalData(top);
  const RCP<EquilibriumGroup> group =
      rcp(new EquilibriumGroup(global, equilibrium, *z, s, std::make_shared<StepHooks>()));
  const RCP<BalanceTest> test = rcp(new BalanceTest(options.newton));
  group->computeF();
  const auto solver = NOX::Solver::buildSolver(group, test, Teuchos::sublist(top, "NOX"));
  const bool converged = solver->solve() == NOX::StatusTest::Converged;
  iterations += test->iterations();
  statistics.newton_iterations += test->iterations();
  if (converged)
    z = rcp(new Vector(EquilibriumGroup::tpetra(unwrap(solver->getSolutionGroup()).getX()), Teuchos::Copy));
  LOCA::destroyGlobalData(global);
  return converged;
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

// Damped steps at fixed load, each from where the last one ended: the damping fades by tens, and grows by a hundred
// where a step fails.
bool Simulation::Data::relax() {
  constexpr int most_steps = 40;
  const double last = 1e-6 * fallback_damping(), largest = 1e8 * fallback_damping();
  double coefficient = 100.0 * fallback_damping();
  for (int k = 0; k < most_steps && coefficient > last; ++k) {
    if (coefficient > largest) return false;
    equilibrium->set_damping(coefficient);
    equilibrium->start_step(*z, 1.0);
    const bool converged = solve(1.0);
    if (converged) dissipated += equilibrium->dissipation(*z, 1.0);
    coefficient *= converged ? 0.1 : 100.0;
  }
  equilibrium->start_step(*z, 1.0);
  return finish();
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
  for (int round = 0; round < most_rounds; ++round) {
    if (!come_to_rest()) return false;
    const State now = equilibrium->state(*z, 1.0);
    const Held held{held_positions(problem, released), held_rotations(problem, now, released)};
    const std::vector<bool> guided = in_contact(now);
    if (find_null_motions(problem, now, held, drive.seam_end >= 1.0, guided).size() == pinned.size()) return true;
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
  message << "stage \"" << stage.name << "\": there is no equilibrium: a force of " << balance.pin_magnitude
          << " N acts along motions of the garment that nothing resists (" << motions
          << "). Hold the garment against them by a support.";
  throw base::SolveError(message.str());
}

std::string Simulation::Data::failure() const {
  std::string text = "stage \"" + stage.name + "\": no undamped equilibrium was found at its end";
  if (statistics.steps > earlier_steps)
    text += std::string("; the last converged ") + (stage.damping.active ? "(damped) " : "") +
            "state was kept, and its pressures must not be read as final.";
  else
    text += ", and no step of it was accepted.";
  return text + (stage.damping.active || stage.arc_length ? "" : " Try damping.");
}

void Simulation::Data::judge(const StepReport& last) {
  const std::string where = "stage \"" + stage.name + "\": ";
  if (last.negative_pivots > 0)
    warnings.push_back(where + "its final state is not stable (" + std::to_string(last.negative_pivots) +
                       " negative pivots): a small disturbance would take the garment elsewhere");
  if (last.negative_pivots < 0)
    warnings.push_back(where +
                       "it is not known whether its final state is stable (the tangent could not be factorised)");
  if (stage.damping.active && dissipated > stage.damping.limit * largest_energy)
    warnings.push_back(where +
                       "the damping dissipated more than the limit; its path was not quasi-static (the final state is "
                       "undamped)");
}

void Simulation::Data::run_stepper() {
  const RCP<Teuchos::ParameterList> top = Teuchos::parameterList();
  top->sublist("NOX") = *newton_parameters(line_search());
  Teuchos::ParameterList& loca = top->sublist("LOCA");
  Teuchos::ParameterList& stepper = loca.sublist("Stepper");
  stepper.set("Continuation Method", stage.arc_length ? "Arc Length" : "Natural");
  stepper.set("Continuation Parameter", "s");
  stepper.set("Initial Value", 0.0);
  stepper.set("Min Value", -1e3);  // never met: between limit points the load may change its sign
  stepper.set("Max Value", 1.0);
  stepper.set("Max Steps", stage.max_steps);
  stepper.set("Max Nonlinear Iterations", options.newton.max_iterations);
  stepper.set("Compute Eigenvalues", false);
  Teuchos::ParameterList& size = loca.sublist("Step Size");
  size.set("Method", "Adaptive");
  size.set("Initial Step Size", stage.first_step);
  size.set("Min Step Size", stage.smallest_step);
  size.set("Max Step Size", stage.largest_step);
  size.set("Aggressiveness", 1.0);
  loca.sublist("Predictor").set("Method", "Secant");
  loca.sublist("Predictor").sublist("First Step Predictor").set("Method", problem.surface ? "Constant" : "Tangent");

  const RCP<LOCA::GlobalData> global = LOCA::createGlobalData(top);
  const RCP<BalanceTest> test = rcp(new BalanceTest(options.newton));
  const auto hooks = std::make_shared<StepHooks>();
  hooks->before = [](const Vector&, double) {};
  hooks->after = [&](const Vector& at, double s, bool converged) {
    iterations += test->iterations();
    statistics.newton_iterations += test->iterations();
    if (!converged) {
      ++cut_backs;
      ++statistics.cut_backs;
      return;
    }
    z = rcp(new Vector(at, Teuchos::Copy));
    accept(s, test->last(), false);
    equilibrium->update_thickness(*z, s, 0.0);
  };
  const RCP<EquilibriumGroup> group = rcp(new EquilibriumGroup(global, equilibrium, *z, 0.0, hooks));
  LOCA::Stepper run(global, group, test, top);
  run.run();
  LOCA::destroyGlobalData(global);
}

void Simulation::Data::march() {
  if (stage.damping.active) choose_damping();
  run_stepper();
  constexpr double round_off = 1e-12;
  if (reached >= 1.0 - round_off) return;  // LOCA's status calls it a failure if the last allowed step gets there
  std::ostringstream message;
  message << "stage \"" << stage.name << "\" could not reach its end: it stopped at ";
  if (stage.type == StageType::sew)
    message << state.seam * 100.0 << " % of the seams' closing";
  else
    message << "load " << state.load << " of " << stage.target;
  message << ", after " << cut_backs << " cut-backs at that point (\"smallest step\" " << stage.smallest_step
          << ", \"most steps\" " << stage.max_steps << "). Try a smaller \"smallest step\" or more steps"
          << (stage.arc_length ? ", or a target that lies on the path." : ", damping, or a start nearer to the end.");
  throw base::SolveError(message.str());
}

void Simulation::run(const StageOptions& stage) {
  Data& d = *data_;
  d.stage = stage;
  d.build();
  if (stage.type != StageType::settle) d.march();
  if (!d.conclude()) throw base::SolveError(d.failure());
  d.check_pins();
  Vector f(d.z->getMap());
  d.equilibrium->residual(*d.z, 1.0, f);
  d.judge(d.accept(1.0, d.equilibrium->imbalance(f), true));
  d.count_linear_work();
}

}  // namespace toile::solve
