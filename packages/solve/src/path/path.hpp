#pragma once

#include <memory>

#include "path/continuation.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

/// The steps of a stage towards s = 1. All that the next step depends on, besides the equilibrium and where it starts,
/// is its memory.
class Path {
 public:
  /// `tangent_first`: the first step is predicted along the tangent. `accepts`: may be empty.
  Path(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage, const NewtonOptions& options,
       bool tangent_first, AcceptsStep accepts);
  virtual ~Path() = default;

  /// Tries a step from the accepted state (z, s).
  virtual Attempt step(const Vector& z, double s) = 0;
  /// The step to `end` counts: it tells where the next one goes and how long it is.
  void go_on(const Vector& from, double s, const Attempt& end);
  /// The step does not count: the next one is shorter. False: it was the shortest.
  bool shorten();

  /// Whether the stage's end is near enough, after a step that was aimed at it, for one more at the end itself.
  bool is_at_end(double s) const;
  /// Tries that one.
  Attempt land(const Vector& z);
  /// Steps that were tried, failed ones included; `land` does not count.
  int attempts() const { return memory_.attempts; }

  PathMemory memory() const;
  void resume(const PathMemory& memory);

 protected:
  /// Direction of the next step, for |ds| = 1; null: not known.
  RCP<const Vector> direction(const Vector& z, double s);
  /// Sign of ds in it.
  double sign() const { return memory_.interval < 0.0 ? -1.0 : 1.0; }
  /// Shortens the next step to one that ends at the stage's end, if it would go beyond. `rate`: of s along the step.
  void aim(double s, double rate);
  /// After the direction has changed: factor of lengths of steps.
  virtual double rescale(const Vector& direction) = 0;
  const AcceptsStep& accepts() const { return accepts_; }

  const std::shared_ptr<Equilibrium> equilibrium_;
  const StageOptions stage_;
  const NewtonOptions options_;
  PathMemory memory_;

 private:
  void clip();

  bool tangent_first_;
  AcceptsStep accepts_;
  RCP<const Vector> change_;   ///< of the last step; null: there is none
  RCP<const Vector> tangent_;  ///< of the first one, once it is known
};

/// Natural continuation, or along the arc if the stage says so.
std::unique_ptr<Path> make_path(std::shared_ptr<Equilibrium> equilibrium, const StageOptions& stage,
                                const NewtonOptions& options, bool tangent_first, AcceptsStep accepts);

}  // namespace toile::solve
