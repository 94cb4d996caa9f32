#pragma once

#include "membrane_point.hpp"

namespace toile::element {

/// Bilinear shape functions on [-1, 1]^2 at the 2 x 2 Gauss points; point p lies nearest to node p.
Rule<4, 4> bilinear();
/// The same at the centre alone.
Rule<4, 1> bilinear_centre();
/// Area coordinates of the parent triangle (0, 0), (1, 0), (0, 1) at its centroid.
Rule<3, 1> linear();
/// The same at three inner points, exact for quadratics; point p lies nearest to node p.
Rule<3, 3> linear_three_points();

/// Parent coordinates of the points of bilinear() and linear_three_points().
double bilinear_place(int point, int axis);
double linear_place(int point, int axis);

}  // namespace toile::element
