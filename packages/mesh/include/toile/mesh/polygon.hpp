#pragma once

#include <optional>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

/// Signed area of a closed polygon (the last point is joined to the first), mm^2; positive: counter-clockwise.
double signed_area(const std::vector<Vec2>& polygon);

/// A point where two sides of the closed polygon meet that are not neighbours, or where neighbours fold back onto each
/// other; nothing if the polygon is simple.
std::optional<Vec2> find_self_intersection(const std::vector<Vec2>& polygon);

}  // namespace toile::mesh
