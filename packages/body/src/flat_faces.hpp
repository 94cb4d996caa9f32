#pragma once

#include <string>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Flat faces with vertices inside them that meet at edges: a body of coarse facets that were cut finer without being
/// rounded. The smooth surface follows them.
struct FlatFaces {
  double share = 0.0;  ///< of the area, what belongs to vertices inside such faces
  double angle = 0.0;  ///< at which they meet, mean, radians
  double width = 0.0;  ///< mm, mean
};

/// Faces count where they meet each other; a flat sole beside round sides does not.
FlatFaces find_flat_faces(const TriangleMesh& mesh);

/// What they do to the surface and to pressures, with figures and the way out.
std::string flat_faces_text(const FlatFaces& faces);
/// Whether the surface shows them, and whether it shows nothing else.
bool matter(const FlatFaces& faces);
bool prevail(const FlatFaces& faces);

}  // namespace toile::body
