#pragma once

#include <vector>

#include "figure/scan.hpp"

namespace toile::body {

/// A section across an arm.
struct ArmStation {
  Vec3 centre = Vec3::Zero();
  Vec3 direction = Vec3::Zero();  ///< towards the hand, unit
  double girth = 0.0;             ///< tape girth, mm
  double along = 0.0;             ///< from the first station, mm
};

/// The arm from the armpit to where its fingers part or it ends; empty if it cannot be followed.
std::vector<ArmStation> arm_line(const FigureScan& scan, const Vec3& armpit, int side);

/// Normal of the plane through the armpit that parts arm and shoulder: half way between the arm, whose direction is
/// given, and the shoulder, which is level.
inline Vec3 armhole_normal(const Vec3& direction, int side) {
  const Vec3 level(side, 0.0, 0.0);
  return (Vec3(direction.x(), 0.0, direction.z()).normalized() + level).normalized();
}

}  // namespace toile::body
