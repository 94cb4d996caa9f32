#pragma once

#include "path/path.hpp"

namespace toile::solve {

/// Steps of s, each predicted along the one before.
class NaturalPath : public Path {
 public:
  using Path::Path;
  Attempt step(const Vector& z, double s) override;

 protected:
  double rescale(const Vector&) override { return 1.0; }
};

}  // namespace toile::solve
