#pragma once

#include <optional>

#include "toile/criteria/criterion.hpp"

namespace toile::criteria {

/// How one homogeneous test holds its specimen.
struct Path {
  const char* name;
  bool wale, course;  ///< which axes are stretched by the path's stretch
  bool free;          ///< the other axis is free of stress (uniaxial); held otherwise (strip)
};

/// Wale and course, uniaxial and strip, and equibiaxial.
std::vector<Path> paths();

/// Where a path from C = I up (or down) to `end` first meets a loss: stretches to 1e-6, none if it is kept.
struct Losses {
  std::optional<double> ellipticity, convexity;
  std::optional<double> range;  ///< the law is continued outside its calibrated range from here on
  std::optional<double> force;  ///< the force along the path stops growing (its nominal stress has a limit)
  std::optional<double> state;  ///< no admissible state is found from here on
};

/// Outputs of `path` at `stretch`; of a free axis by Newton from `guess` (S of that axis and S12 vanish). Empty if
/// there is none.
std::optional<Outputs> state_on(const Fabric& fabric, const Path& path, double stretch, const Strain& guess);

Losses losses(const Fabric& fabric, const Path& path, double end);

/// One reported line a path: first losses in tension and in compression.
std::vector<Finding> path_findings(const Fabric& fabric, const Request& request);

}  // namespace toile::criteria
