#pragma once

#include "spline_field.hpp"
#include "surface_samples.hpp"

namespace toile::body {

/// The level set f, and what it would change by if the smoothing's weight were six times as large, to first order in its
/// logarithm.
struct LevelSetFit {
  SplineField field;
  SplineField doubt;
};

/// Least-squares fit of a level set to vertices (f = 0) and vertex normals (grad f = n), with the integral of the
/// squared third derivatives times `smoothing`, less where the surface bends much; see the README. `samples`: of the
/// mesh, half a cell apart. Throws InputError if the system cannot be factorised.
LevelSetFit fit_level_set(const TriangleMesh& mesh, const SurfaceSamples& samples, double cell, double smoothing);

}  // namespace toile::body
