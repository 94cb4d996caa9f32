#pragma once

#include "path/path.hpp"

namespace toile::solve {

/// Steps of the arc length, which counts s with a weight: over limit points, where s turns back. LOCA solves for the
/// state at the step's length.
class ArcPath : public Path {
 public:
  using Path::Path;
  Attempt step(const Vector& z, double s) override;

 protected:
  double rescale(const Vector& direction) override;

 private:
  /// Of s along the arc, in a direction with |ds| = 1.
  double rate(const Vector& direction) const;
  void find_weight(const Vector& direction);
};

}  // namespace toile::solve
