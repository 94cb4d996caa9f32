#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "arc_watch.hpp"
#include "continuation.hpp"
#include "critical_points.hpp"
#include "damped_watch.hpp"
#include "damping.hpp"
#include "held.hpp"
#include "notes.hpp"
#include "null_motion.hpp"
#include "path.hpp"
#include "path_target.hpp"
#include "path_watch.hpp"
#include "toile/solve/checkpoint.hpp"
#include "toile/solve/simulation.hpp"
#include "watch.hpp"

namespace toile::solve {

/// What a simulation holds. Its functions are in simulation.cpp (steps), simulation_path.cpp (to the end of a stage),
/// simulation_end.cpp (the final state there), simulation_checkpoint.cpp (going on) and simulation_texts.cpp (what is
/// said).
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
  std::vector<StepReport> reports;
  int stages_run = 0, stages_behind = 0;  ///< those that were asked for; of them, those that a resumed run has done
  double earlier_seconds = 0.0;           ///< of the run before it was resumed
  std::optional<Checkpoint> resumed;      ///< inside the stage that runs next

  // Of the stage that runs.
  StageOptions stage;
  StagePhase phase = StagePhase::path;
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
  std::optional<PathWatch> path_watch;      ///< of a path that can be left unseen: step by step in the load
  std::optional<ArcWatch> arc_watch;        ///< of a path of arc length
  std::optional<DampedWatch> damped_watch;  ///< of a damped stage
  double last_move = 0.0;                   ///< of the last damped step, mm
  double faded = 0.0;                       ///< dissipated in the search for the final state, N mm
  std::unique_ptr<Path> path;
  std::optional<TargetSearch> target;            ///< of a path that ends elsewhere than at its load
  double stabilised = 0.0, stabilised_at = 0.0;  ///< largest share of the energy that only stabilises, and its load
  bool lost_ellipticity = false;
  std::optional<Attempt> failed;  ///< the last one
  double failed_damping = 0.0;

  Data(const Problem& p, const SolverOptions& o);

  void begin();
  void build();
  std::vector<NullMotion> null_motions(const State& from, const std::vector<bool>& guided) const;
  void assemble(const State& from, const std::vector<NullMotion>& motions);
  StepReport accept(double s, const Imbalance& imbalance, bool undamped);
  double seconds() const;
  void publish(const StepReport& report);
  Checkpoint checkpoint() const;
  void resume(const Checkpoint& from);
  void rebuild(const Checkpoint& from);
  bool solve(double s);
  bool finish();
  bool relax();
  bool come_to_rest();
  bool strayed(const State& damped, int taken);
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
  void tell_of_damping();
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
  void start_path();
  bool begin_path();
  void follow_path();
  void count(const Attempt& attempt);
  bool oversteps(const Attempt& attempt) const;
  bool record(const Attempt& attempt);
  bool arrive();
  void hold_load();
};

}  // namespace toile::solve
