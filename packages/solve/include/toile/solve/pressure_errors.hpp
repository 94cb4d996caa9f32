#pragma once

#include <vector>

namespace toile::solve {

/// Estimates of the parts of a pressure's error, which are independent of each other: [node] MPa.
struct PressureErrors {
  std::vector<double> mesh, body, gap, solver, damping, slack;

  /// Root of the sum of the squares of the parts.
  double total(size_t node) const;
};

/// One part.
struct ErrorPart {
  const char* name;
  const char* text;
  std::vector<double> PressureErrors::*values;
};

/// In the order in which they are told. The first is that of the mesh.
const std::vector<ErrorPart>& error_parts();

}  // namespace toile::solve
