#pragma once

#include "toile/criteria/criterion.hpp"

namespace toile::criteria {

/// What is known of one state of the box.
struct MapPoint {
  double wale, course, shear;  ///< F = [[wale, shear], [0, course]]
  Outputs state;
  bool tensile = false;           ///< both principal stresses
  double ellipticity = 0.0;       ///< smallest eigenvalue of the acoustic tensor over all directions, MPa
  double direction = 0.0;         ///< angle of that direction from the wale, degrees
  bool elliptic = false;          ///< none negative beyond rounding
  double convexity = 0.0;         ///< smaller eigenvalue of d2W/dl_i dl_j, principal directions held, MPa
  bool convex = false;            ///< not negative beyond rounding
  double condition = 0.0;         ///< of the tangent D in orthonormal (Mandel) components: ratio of its singular values
  bool tangent_positive = false;  ///< D is positive definite
};

/// Evaluates `s` alone. NaN where it is not admissible.
MapPoint map_point(double wale, double course, double shear, const Outputs& s);

/// Every state of the box; wale runs fastest, then course, then shear.
std::vector<MapPoint> map(const Fabric& fabric, const Request& request);

/// Ellipticity and convexity in tension (criteria) and anywhere, range of validity and conditioning (figures).
std::vector<Finding> judge(const std::vector<MapPoint>& map);

}  // namespace toile::criteria
