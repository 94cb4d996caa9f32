#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>

#include "toile/base/parameters.hpp"
#include "toile/body/analytic.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// Where a garment can touch the body: triangles outside are left out of trees and fits. Bodies given by a formula do
/// not need it.
struct Region {
  Vec3 lower = Vec3::Constant(-std::numeric_limits<double>::infinity());  ///< mm
  Vec3 upper = Vec3::Constant(std::numeric_limits<double>::infinity());   ///< mm
  /// Of the pieces that the box cuts out of the body (two legs), only the one nearest to this point is kept, mm.
  std::optional<Vec3> seed;
};

/// Description of the scene's list "Body".
base::Spec body_spec();

/// The body that the validated list describes. `region` (may be null): where the garment can reach; what the list
/// itself says in "Reach" goes before it. Files are looked for in the folder of the scene file.
/// Throws InputError for a file that cannot be used, saying why.
SurfacePtr make_surface(const base::List& list, const Region* region);

}  // namespace toile::body
