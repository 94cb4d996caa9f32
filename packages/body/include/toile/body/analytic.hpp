#pragma once

#include <memory>
#include <string>

#include "toile/body/profile.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

using SurfacePtr = std::shared_ptr<const Surface>;

/// Part of an endless body that pictures show, in mm. It does not bound the surface.
struct Span {
  double bottom = 0.0;
  double top = 0.0;
};

/// Bodies given by a formula, about the z axis. The gap is the global minimum; gap, normal and Hessian are exact to
/// round-off. A point is not `found` where the gap has no derivatives (on the axis, at a centre of curvature).

/// Body of revolution with the given profile; `name` stands in the summary.
SurfacePtr revolution(ProfilePtr profile, Span shown, const std::string& name);

/// x^2/a^2 + y^2/b^2 = 1.
SurfacePtr elliptic_cylinder(double a, double b, Span shown);

/// (x^2 + y^2)/radius^2 + z^2/half_height^2 = 1; centre in the origin.
SurfacePtr ellipsoid(double radius, double half_height);

}  // namespace toile::body
