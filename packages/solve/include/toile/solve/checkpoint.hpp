#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "toile/solve/simulation.hpp"

namespace toile::solve {

/// Values of all unknowns, the same on every rank: [cluster] three components of the position and the contact
/// multiplier, then [node] two rotations of shells. Empty: there is no such vector.
using Unknowns = std::vector<double>;

/// What the equations of a stage remember from one step to the next.
struct EquilibriumMemory {
  Unknowns z;      ///< at which the next step begins
  double s = 0.0;  ///< there
  /// [cluster] contact surface inside the mid-surface, mm; empty without a body, as all of contact.
  std::vector<double> offset;
  std::vector<double> contact_history;  ///< as State::contact_history
  std::vector<Vec3> normal;             ///< [cluster] of the contact set at the last linearisation; zero: not in it
  std::vector<Frame> frame;             ///< [node] of directors; empty without shells
  std::vector<double> rotation;         ///< [node][2] theta that belongs to it
  std::vector<double> frozen;  ///< [block][element] what elements keep during a step, see element::Element::freeze
  double damping = 0.0;        ///< coefficient
  double shift = 0.0;          ///< of the last tangent that was not positive definite
};

/// What the next step of a path depends on besides.
struct PathMemory {
  double step = 0.0;                     ///< length of the next one: of s, or of the arc
  double smallest = 0.0, largest = 0.0;  ///< in the same measure
  bool is_smallest = false;              ///< the next one is the last that is tried
  bool aimed = false;                    ///< the last one, which counts, was aimed at the end
  double weight = 1.0;                   ///< of s in the arc length
  int attempts = 0;                      ///< steps tried
  Unknowns change;                       ///< of the last step
  double interval = 0.0;                 ///< of s in it
};

/// The largest of the steps that a watch has found, and the part of the stage in which they lie.
struct FoundSteps {
  int count = 0;
  double first = 0.0, end = 0.0;  ///< loads (or closings) where the first began and the last ended
  bool has_largest = false;
  double from = 0.0, to = 0.0;  ///< of the largest
  double distance = 0.0;        ///< by which a point moved in it, mm; or its turn, degrees
  Vec3 at = Vec3::Zero();       ///< that point
  double dissipated = 0.0;      ///< in the largest, N mm
  double share = 0.0;           ///< of it of the strain energy
  double part = 0.0;            ///< of the stage, in all
  double taken = 0.0;           ///< dissipated in all, N mm
};

/// What the watches of a stage remember.
struct WatchMemory {
  Unknowns start, last, change;  ///< of the stage; accepted; of the last step
  double s = 0.0;                ///< accepted
  double interval = 0.0;         ///< of s in the last step
  double first_length = 0.0;     ///< of an arc's first step, mm
  FoundSteps found;              ///< jumps, or turns
};

/// Pivots at the last accepted state that was looked at.
struct PivotMemory {
  int pivots = -1;
  double load = 0.0, s = 0.0, direction = 1.0;
  Unknowns z;
};

/// Where the quantity of a path's end was.
struct TargetMemory {
  Unknowns before, after;
  double s_before = 0.0, s_after = 0.0, value_before = 0.0, value_after = 0.0;
};

/// A component that is held against a null motion.
struct Pin {
  std::string motion;
  int cluster = 0;
  int component = 0;  ///< 0..2
};

/// How far a stage has come.
enum class StagePhase {
  path,     ///< on its path, or at the end of it
  arrived,  ///< where a quantity has its value; its final state is to be found at that load
  finished  ///< its final state is found: the next stage follows
};

/// Of a run so far, N mm.
struct Energies {
  double largest = 0.0, last = 0.0;  ///< of strain, at accepted steps
  double dissipated = 0.0;           ///< by damping
};

/// How far a stage has come, and what there is to say of it at its end.
struct StageProgress {
  StagePhase phase = StagePhase::path;
  State start;                                   ///< at which its equations were set up
  int earlier_steps = 0;                         ///< before it
  double last_move = 0.0;                        ///< of the last damped step, mm
  double stabilised = 0.0, stabilised_at = 0.0;  ///< largest share of energy that only stabilises, and its load
  bool lost_ellipticity = false;
};

/// The stage that a step belongs to.
struct StageMemory {
  int index = 0;
  std::string name;
  int iterations = 0;  ///< since it began
  StageProgress progress;
};

/// Of the watches that the stage has.
struct WatchMemories {
  std::optional<WatchMemory> path, arc;
  std::optional<FoundSteps> damped;
};

/// What a run has noted; of that, the stage's pins.
struct NoteMemory {
  std::vector<std::string> all;
  int first_pin = 0, pins = 0;
};

/// Everything that a run needs to go on after an accepted step, with the same bits on the same number of ranks. Plain
/// values, the same on every rank.
struct Checkpoint {
  StageMemory stage;
  State state;  ///< of the step
  std::vector<Pin> pins;
  std::set<std::string> released;
  EquilibriumMemory equilibrium;
  PathMemory path;
  WatchMemories watches;
  std::optional<TargetMemory> target;
  PivotMemory pivots;
  Energies energies;
  double seconds = 0.0;  ///< wall time of the run
  SolveStatistics statistics;
  NoteMemory notes;
  std::vector<std::string> warnings;
  std::vector<StepReport> reports;  ///< of all accepted steps
};

/// A checkpoint as named arrays, for a file. Names hold no '/'.
struct CheckpointArrays {
  std::map<std::string, std::vector<double>> reals;
  std::map<std::string, std::vector<int>> integers;
  std::map<std::string, std::string> texts;
};
CheckpointArrays to_arrays(const Checkpoint& checkpoint);
/// The same checkpoint, bit for bit. Throws base::InputError if an array is missing, or not as long as it must be.
Checkpoint from_arrays(const CheckpointArrays& arrays);

}  // namespace toile::solve
