// What all bodies that are fitted to triangles have in common.
#pragma once

#include <string>

#include "toile/body/body.hpp"

namespace toile::body {

/// Part of a body that is kept, and who says so.
struct Reach {
  Region region;
  std::string source;  ///< for the summary; empty: nobody, all of it is kept
};

/// The list "Reach" of the body, or else `region` (may be null).
Reach read_reach(const base::List& list, const Region* region);

/// Throws InputError at `parameter` if no triangle is left.
void check_in_reach(const base::List& list, const std::string& parameter, const TriangleMesh& mesh);

/// The smooth surface that the list's "cell" and "smoothing" ask for. Throws InputError.
SurfacePtr fit_surface(const base::List& list, TriangleMesh mesh, const std::string& name);

}  // namespace toile::body
