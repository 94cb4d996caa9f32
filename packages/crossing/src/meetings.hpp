#pragma once

#include <array>
#include <vector>

#include "fabric.hpp"

namespace toile::crossing {

using Segment = std::array<Vec3, 2>;

/// Two elements whose mid-surfaces have lines in common: they cross, touch, or lie on each other.
struct Meeting {
  int first = 0, second = 0;      ///< elements, the smaller index first
  std::vector<Segment> segments;  ///< one for each two of their triangles that meet
};

/// All of them that are not joined, by their elements. Triangles in one plane, and those that meet in a point, do not
/// count.
std::vector<Meeting> find_meetings(const Fabric& fabric);

/// Distance of a point from the plane of the nearest of some triangles, mm; above zero on the side of its normal. Zero
/// without triangles, and where the point lies beside rather than above them.
double height_above(const std::vector<Triangle>& triangles, const Vec3& point);

}  // namespace toile::crossing
