#pragma once

#include "toile/body/analytic.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

struct LevelSetOptions {
  double cell = 0.0;       ///< mm; 0: from the mean edge length
  double smoothing = 0.0;  ///< weight lambda of the third derivatives; 0: from the mean edge length and the cell
};

/// Smooth surface f = 0 of a tricubic B-spline f that is fitted once to vertices and vertex normals of `mesh`
/// (derivation and measurements: README of this package). C2, so gap, normal and Hessian are continuous.
/// A point further than range() from the facets gets found = false and the signed distance to the facets.
/// `name` and `notes` go into the summary. Throws InputError if the mesh is empty or the fit is singular.
SurfacePtr level_set(TriangleMesh mesh, const LevelSetOptions& options, const std::string& name);

/// The facets as they are, with zero Hessian: only to show what faceting does to a pressure.
SurfacePtr facet_surface(TriangleMesh mesh, const std::string& name);

}  // namespace toile::body
