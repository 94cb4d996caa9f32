#pragma once

#include <optional>

#include "path/continuation.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

/// A state on the path of a stage.
struct PathPoint {
  RCP<const Vector> z;
  double s = 0.0;
};

/// Looks for the state of a path at which a quantity has its value (PathTarget): between two steps, as one more
/// equation for the parameter s, so that it is found on rising and on falling branches.
class TargetSearch {
 public:
  TargetSearch(const Problem& problem, std::shared_ptr<Equilibrium> equilibrium, const PathTarget& target,
               const NewtonOptions& options);

  /// Whether the quantity passed its value since the last call with a step, in (z, s) being the next one.
  bool passed(const Vector& z, double s);
  /// The state between the last two steps; nothing: Newton's method did not find it.
  std::optional<PathPoint> find();
  /// The state near a point, for instance after the thickness of shells was updated.
  std::optional<PathPoint> find_near(const PathPoint& start);

  TargetMemory memory() const;
  void resume(const TargetMemory& memory);

 private:
  double measure(const Vector& z, double s);
  /// Derivative of the quantity along (dz, ds), by differences.
  double slope(const PathPoint& at, const Vector& dz, double ds);

  const Problem& problem_;
  std::shared_ptr<Equilibrium> equilibrium_;
  PathTarget target_;
  NewtonOptions options_;
  PathPoint before_, after_;
  double value_before_ = 0.0, value_after_ = 0.0;
};

}  // namespace toile::solve
