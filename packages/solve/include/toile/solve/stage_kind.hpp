#pragma once

#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/solve/options.hpp"
#include "toile/solve/problem.hpp"

namespace toile::solve {

/// Seams and load as functions of the stage's parameter s in [0, 1].
struct Drive {
  double seam_start = 0.0, seam_end = 0.0;
  double load_start = 0.0, load_end = 0.0;
  double seam(double s) const { return seam_start + (seam_end - seam_start) * s; }
  double load(double s) const { return load_start + (load_end - load_start) * s; }
};

/// What happens in a stage. Each kind is a file of its own, and a line in the list of stage_kind.cpp.
class StageKind {
 public:
  StageKind() = default;
  StageKind(const StageKind&) = delete;
  StageKind& operator=(const StageKind&) = delete;
  virtual ~StageKind() = default;

  /// Its word in the input.
  virtual const char* name() const = 0;
  /// Its parameters in the input, and how they are read into the options. Throws base::InputError.
  virtual base::Spec spec() const = 0;
  virtual void read(const base::List& list, StageOptions& stage) const = 0;

  /// What it drives, from the state at its start.
  virtual Drive drive(const StageOptions& stage, const State& start) const;
  /// Whether it goes step by step to its end, rather than to an equilibrium at once.
  virtual bool has_path() const { return true; }
  virtual bool closes_seams() const { return false; }
  /// Whether it goes on in the load.
  virtual bool changes_load() const { return false; }

  /// How far it has come, in the measure of `measure()`, and in words ("load 0.3 of 1").
  virtual double reached(const State& state) const { return state.load; }
  virtual const char* measure() const { return "load"; }
  virtual std::string reached_text(const StageOptions& stage, const State& state) const;
};

/// All kinds, in the order in which they are described.
const std::vector<const StageKind*>& stage_kinds();
/// The one of this name. Throws base::InputError with the nearest one if there is none.
const StageKind& stage_kind(const std::string& name);

}  // namespace toile::solve
