#pragma once

#include <Eigen/Core>

#include "toile/body/profile.hpp"

namespace toile::body {

/// Closest point on a plane curve.
struct PlanarPoint {
  Eigen::Vector2d foot = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< outward unit normal at the foot
  double curvature = 0.0;                            ///< at the foot, 1/mm, positive where the body is convex
  double gap = 0.0;                                  ///< signed distance, mm
};

/// Ellipse x^2/a^2 + y^2/b^2 = 1, any point. On the segment between the focal points of the inside, where two feet are
/// equally near, one of them.
PlanarPoint closest_on_ellipse(double a, double b, const Eigen::Vector2d& point);

/// Meridian (r(z), z) of a body of revolution; `point` = (distance from the axis, z).
PlanarPoint closest_on_profile(const Profile& profile, const Eigen::Vector2d& point);

}  // namespace toile::body
