#pragma once

#include <memory>
#include <vector>

namespace toile::body {

/// Radius r(z) of a body of revolution about the z axis, with its derivatives; defined and smooth for every z.
class Profile {
 public:
  struct Value {
    double radius = 0.0;  ///< mm
    double slope = 0.0;   ///< dr/dz
    double bend = 0.0;    ///< d2r/dz2, 1/mm
  };
  virtual ~Profile() = default;
  virtual Value at(double z) const = 0;
  /// Length in z over which the slope varies noticeably, mm: the search for the closest point samples this finely.
  virtual double variation() const = 0;
};

using ProfilePtr = std::shared_ptr<const Profile>;

/// r = radius + slope z. Slope 0 is a cylinder.
ProfilePtr linear_profile(double radius, double slope);

/// r = radius + amplitude cos(2 pi z / period).
ProfilePtr cosine_profile(double radius, double amplitude, double period);

/// How a spline profile ends below its lowest level. Above the highest one it always ends straight.
enum class LowerEnd {
  straight,  ///< no curvature at the end, continued by its tangent
  mirrored   ///< slope zero at the end, continued as its mirror image (the ankle: girth grows again towards the heel)
};

/// Curvature-continuous (C2) cubic spline through (levels[i], radii[i]); two or more levels, strictly increasing.
/// Both kinds of end keep the extended profile C2.
ProfilePtr spline_profile(const std::vector<double>& levels, const std::vector<double>& radii,
                          LowerEnd lower_end = LowerEnd::straight);

}  // namespace toile::body
