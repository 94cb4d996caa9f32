#pragma once

#include "kinds.hpp"

namespace toile::body {

/// A smooth surface fitted to the triangles of a file.
SurfacePtr make_from_file(const base::List& list, const Region* region, BodyFindings* findings);

}  // namespace toile::body
