#pragma once

#include <vector>

#include "toile/body/surface.hpp"

namespace toile::scene {

/// A way on a smooth surface whose ends stay, drawn tight: the geodesic near it, by Newton's method on its geodesic
/// curvature. `step` (mm): distance of the points that are returned. Empty where it does not become tight, or leaves
/// what is known of the surface.
std::vector<body::Vec3> straightened(const body::Surface& surface, const std::vector<body::Vec3>& way, double step);

}  // namespace toile::scene
