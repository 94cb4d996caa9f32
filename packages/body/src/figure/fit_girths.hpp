#pragma once

#include <vector>

#include "toile/body/landmarks.hpp"
#include "toile/body/mannequin.hpp"

namespace toile::body {

/// What a fit came to.
struct GirthFit {
  TriangleMesh mesh;
  Landmarks landmarks;
  std::vector<Measurement> measurements;
  int rounds = 0;
};

/// Moves the surface of a form smoothly until it has the measurements, each within 0.8 %: the sections at the
/// landmarks are scaled, and between them the displacement bends least. Throws InputError if they are not reached.
GirthFit fit_girths(const TriangleMesh& form, const std::vector<Measurement>& measurements);

}  // namespace toile::body
