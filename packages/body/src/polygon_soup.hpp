#pragma once

#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Polygons over shared points, mm (or the unit of a file).
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<std::vector<std::size_t>> polygons;
};

}  // namespace toile::body
