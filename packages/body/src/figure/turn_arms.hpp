#pragma once

#include "toile/body/landmarks.hpp"
#include "toile/body/surface.hpp"

namespace toile::body {

/// Angle of the upper arms below the level, seen from the front, degrees; the mean of both.
double arm_angle(const Landmarks& landmarks);

/// Turns both arms about the shoulders until they hang at `angle`; from the trunk to the upper arm the turn grows
/// smoothly. Throws InputError if `landmarks` lack the arms.
TriangleMesh turn_arms(const TriangleMesh& form, const Landmarks& landmarks, double angle);

}  // namespace toile::body
