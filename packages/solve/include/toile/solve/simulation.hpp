#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "toile/solve/options.hpp"
#include "toile/solve/problem.hpp"

namespace toile::solve {

/// Forces of a configuration, summed over the garment (N). Those of body, supports, loads and damping add up to zero in
/// equilibrium.
struct ForceBalance {
  Vec3 contact = Vec3::Zero();  ///< of the body on the garment
  std::vector<Vec3> support;    ///< reaction of each support, in the order of Problem::supports
  std::vector<double> torque;   ///< [support] moment of the support about the axis of its turn, N mm; 0 without a turn
  Vec3 load = Vec3::Zero();
  Vec3 damping = Vec3::Zero();
  Vec3 pins = Vec3::Zero();    ///< of what is held against null motions; at the end of a stage they carry nothing
  double pin_magnitude = 0.0;  ///< sum of the magnitudes of the pins' forces
  /// Sum of the magnitudes of the nodal forces, pins included, and of the moments over the distance of two nodes. Not
  /// less than the forces that round-off leaves would need to count.
  double magnitude = 0.0;
  Vec3 sum() const;  ///< without the pins, so that a force that nothing real carries shows
};

/// What lies between an accepted step and the one before, told by a change of the number of negative pivots or, of a
/// jump, by the way back.
enum class CriticalPoint {
  none,
  limit,         ///< the load turned back
  bifurcation,   ///< the load went on: another path branches off
  unclassified,  ///< natural continuation jumps over what lies between its steps
  jump           ///< the path was left for another branch, see the warnings
};

/// How far an accepted state is from equilibrium.
struct Accuracy {
  double residual = 0.0;           ///< relative force residual
  double undamped_residual = 0.0;  ///< the same without the damping force
  double gap = 0.0;                ///< largest violation of contact, mm
  double kept = 0.0;               ///< relative residual that the residual stiffness of slack fabric carries
};

/// Energies at an accepted step, N mm.
struct StepEnergy {
  double strain = 0.0;
  double stabilisation = 0.0;      ///< part of it that only stabilises reduced elements
  double dissipated = 0.0;         ///< by damping, accumulated over the run
  double dissipation_ratio = 0.0;  ///< accumulated dissipation over the largest strain energy
};

/// One accepted step.
struct StepReport {
  std::string stage;
  int step = 0;            ///< counted over the whole run
  double parameter = 0.0;  ///< of the stage, 0..1
  double load = 0.0, seam = 0.0;
  int iterations = 0;  ///< Newton iterations since the last accepted step, failed attempts included
  int cut_backs = 0;   ///< failed attempts since the last accepted step
  Accuracy accuracy;
  StepEnergy energy;
  int negative_pivots = -1;  ///< of the tangent at the accepted state; -1: not known
  double condition = 0.0;    ///< of that tangent: its largest over its smallest eigenvalue; 0: not asked for, not known
  CriticalPoint critical = CriticalPoint::none;
  int extrapolated = 0;   ///< elements outside the calibrated range of their fabric
  bool undamped = false;  ///< this is the final state of its stage, without damping
  ForceBalance balance;
  double seconds = 0.0;  ///< wall time since the start of the run
};

/// An iteration of Newton's method, while a step is sought.
struct IterationReport {
  std::string stage;
  double parameter = 0.0;  ///< that is sought, of the stage, 0..1
  int iteration = 0;       ///< of this attempt
  int cut_backs = 0;       ///< failed attempts since the last accepted step
  bool relaxing = false;   ///< the undamped end of the stage is sought
  double residual = 0.0;   ///< relative force residual
  double gap = 0.0;        ///< largest violation of contact, mm
};
using IterationObserver = std::function<void(const IterationReport&)>;

struct SolveStatistics {
  int newton_iterations = 0;
  int linear_iterations = 0;
  int factorisations = 0;
  int steps = 0;
  int cut_backs = 0;
  int unknowns = 0;
  int contact_nodes = 0;
  double contact_stiffness = 0.0;  ///< N/mm
};

struct Checkpoint;

/// Runs the stages of a scene. Collective over MPI's world; the problem is the same on every rank.
class Simulation {
 public:
  using Observer = std::function<void(const StepReport&, const State&)>;

  Simulation(const Problem& problem, const SolverOptions& options);
  ~Simulation();

  /// Called on every rank after each accepted step.
  void observe(Observer observer);
  /// Called on every rank after each iteration.
  void observe_iterations(IterationObserver observer);
  /// `wanted` is asked on every rank after each iteration: empty, or why the run is to end. Then the stage fails; one
  /// rank is enough.
  void stop_when(std::function<std::string()> wanted);
  /// Starts from a configuration that is not in equilibrium; contact forces are estimated from it.
  void set_start(const State& state);
  /// Starts from a converged state with its contact forces.
  void set_state(const State& state);
  /// Goes on after the step of a checkpoint (checkpoint.hpp), before any stage is run: run() passes over the stages
  /// that are behind it, and goes on inside the one that it belongs to. Throws base::InputError if it is not of this
  /// garment.
  void resume(const Checkpoint& from);
  /// Takes the garment through one stage. Throws base::SolveError if its end cannot be reached; state() is then the
  /// last converged one.
  void run(const StageOptions& stage);

  /// From which a run goes on after the last accepted step; to be asked for by an observer of steps, or between stages.
  Checkpoint checkpoint() const;
  /// Stages that a resumed run has behind it.
  int stages_behind() const;

  const State& state() const;
  const SolveStatistics& statistics() const;
  /// Why a stage had to end before its time (a wish, a limit of steps, time or iterations); empty: none had to.
  const std::string& stopped() const;
  /// What is good to know: null motions that were held.
  const std::vector<std::string>& notes() const;
  /// What limits the trust in the result: a path that was not quasi-static, an end that is not stable.
  const std::vector<std::string>& warnings() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace toile::solve
