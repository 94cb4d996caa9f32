#pragma once

#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Marks the vertices of what the plane through `point` cuts off there on the side of `normal`: of a plane across a
/// wrist the hand, though it meets the trunk too. None are marked if no part of the body near the point lies beyond.
std::vector<char> beyond(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal);

/// Cuts that part off and closes the body with a smooth cap, `height` times as high as wide at its rim. The cap has
/// edges of about `edge` mm along its meridians. Throws InputError if the rim is not one closed curve.
TriangleMesh cut_off(const TriangleMesh& mesh, const Vec3& point, const Vec3& normal, double height, double edge);

}  // namespace toile::body
