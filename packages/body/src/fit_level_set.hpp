#pragma once

#include "spline_field.hpp"
#include "surface_samples.hpp"

namespace toile::body {

/// Least-squares fit of a level set to vertices (f = 0) and vertex normals (grad f = n), with the integral of the
/// squared third derivatives times `smoothing`, less where the surface bends much; see the README. `samples`: of the
/// mesh, half a cell apart. Throws InputError if the system cannot be factorised.
SplineField fit_level_set(const TriangleMesh& mesh, const SurfaceSamples& samples, double cell, double smoothing);

}  // namespace toile::body
