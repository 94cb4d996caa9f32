#pragma once

#include "toile/body/surface.hpp"

namespace toile::test {

/// Two upright legs beside each other under a common trunk: cylinders about (+-(radius + gap/2), 0), from z = -leg to
/// 0, and above them the prism of the outline that a band round both has. Ends are open.
struct TwoLegs {
  double radius = 50.0;  ///< mm
  double gap = 2.0;      ///< mm, smallest distance between the legs
  double leg = 150.0;    ///< mm
  double trunk = 80.0;   ///< mm

  double centre() const { return radius + 0.5 * gap; }
  /// Point of the right leg, at an angle from the other leg, radians.
  body::Vec3 at(double angle, double z) const;
};

/// Triangles with edges of about that length, vertices exactly on the body.
body::TriangleMesh triangulation(const TwoLegs& legs, double edge);

}  // namespace toile::test
