#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "equilibrium/held.hpp"
#include "equilibrium/null_motion.hpp"
#include "path/continuation.hpp"
#include "path/critical_points.hpp"
#include "path/damping.hpp"
#include "path/path.hpp"
#include "path/path_target.hpp"
#include "simulation/notes.hpp"
#include "toile/solve/checkpoint.hpp"
#include "toile/solve/simulation.hpp"
#include "watch/arc_watch.hpp"
#include "watch/damped_watch.hpp"
#include "watch/path_watch.hpp"
#include "watch/watch.hpp"

namespace toile::solve {

/// Wall time of a run.
struct RunClock {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double earlier = 0.0;  ///< seconds before it was resumed
  double seconds() const {
    return earlier + std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

/// How many stages a run was asked for, and how many of them a resumed one has done before.
struct StageCount {
  int run = 0, behind = 0;
};

/// What a simulation holds over all stages.
struct RunSoFar {
  RunSoFar(const Problem& p, const SolverOptions& o, RCP<const Comm> ranks)
      : problem(p), options(o), comm(std::move(ranks)), state(placed_state(p)) {}

  const Problem& problem;
  SolverOptions options;
  RCP<const Comm> comm;
  Simulation::Observer observer;
  State state;
  SolveStatistics statistics;
  Notes notes;
  std::vector<std::string> warnings;
  std::set<std::string> released;
  RunClock clock;
  bool started = false;
  Energies energies;
  std::vector<StepReport> reports;
  StageCount stages;
  std::optional<Checkpoint> resumed;  ///< inside the stage that runs next
};

/// Those that look for what Newton's method does not show.
struct Watches {
  std::optional<PathWatch> path;      ///< of a path that can be left unseen: step by step in the load
  std::optional<ArcWatch> arc;        ///< of a path of arc length
  std::optional<DampedWatch> damped;  ///< of a damped stage
};

/// What it took since the last accepted step.
struct Tries {
  int iterations = 0, cut_backs = 0;
  std::optional<Attempt> failed;  ///< the last one
  double failed_damping = 0.0;
};

/// What it holds of the stage that runs.
struct StageNow {
  StageNow(RCP<const Comm> comm, double most_time) : watch(std::move(comm), most_time) {}

  StageOptions stage;
  StageProgress progress;
  Drive drive;
  Watch watch;
  Held held;
  bool relaxing = false;
  std::shared_ptr<Equilibrium> equilibrium;
  RCP<Vector> z;
  std::vector<NullMotion> pinned;
  Tries tries;
  double reached = 0.0;  ///< s of the last accepted step
  CriticalPoints critical;
  Watches watches;
  double faded = 0.0;  ///< dissipated in the search for the final state, N mm
  std::unique_ptr<Path> path;
  std::optional<TargetSearch> target;  ///< of a path that ends elsewhere than at its load
};

/// Its functions are in simulation.cpp (steps), simulation_path.cpp (to the end of a stage), simulation_end.cpp (the
/// final state there), simulation_checkpoint.cpp (going on) and simulation_texts.cpp (what is said).
struct Simulation::Data : RunSoFar, StageNow {
  Data(const Problem& p, const SolverOptions& o);

  void begin();
  void build();
  std::vector<NullMotion> null_motions(const State& from, const std::vector<bool>& guided) const;
  void assemble(const State& from, const std::vector<NullMotion>& motions);
  StepReport accept(double s, const Evaluation& evaluation, bool undamped);
  void publish(const StepReport& report);
  Checkpoint checkpoint() const;
  void resume(const Checkpoint& from);
  void rebuild(const Checkpoint& from);
  bool solve(double s, double least_tolerance = 0.0);
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
      const int before = tries.iterations;
      if (!solve(s)) return std::nullopt;
      return tries.iterations - before;
    };
  }
  SolveLoosely loose_solver() {
    return [this](double s, double tolerance) -> std::optional<int> {
      const int before = tries.iterations;
      if (!solve(s, tolerance)) return std::nullopt;
      return tries.iterations - before;
    };
  }
  std::string where() const { return "stage \"" + stage.name + "\": "; }
  void count_pivots(double s, StepReport& report);
  void start_path();
  bool begin_path();
  bool took_most_steps();
  void follow_path();
  void count(const Attempt& attempt);
  bool oversteps(const Attempt& attempt) const;
  bool record(const Attempt& attempt);
  bool arrive();
  void hold_load();
};

}  // namespace toile::solve
