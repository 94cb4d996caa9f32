#pragma once

#include <vector>

#include "toile/body/body.hpp"

namespace toile::body {

/// One kind of body that a scene may name.
struct Kind {
  base::Spec spec;  ///< its parameters, in the list "Body"
  /// As make_surface.
  SurfacePtr (*make)(const base::List& list, const Region* region, BodyFindings* findings);
};

/// All kinds; a new one is a source of its own and its line in kinds.cpp.
const std::vector<Kind>& kinds();

}  // namespace toile::body
