#pragma once

#include <functional>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Point of a surface at u (around, counter-clockwise seen from above, period 1) and v (upwards, 0 to 1).
using Chart = std::function<Vec3(double u, double v)>;

/// Number of pieces of about `size` that `length` is divided into, at least `least`. Throws InputError if they are
/// more than 2000: a picture needs no more, and the memory would not suffice.
int divisions(double length, double size, int least);

/// Triangles of a tube that is open at both ends: columns x rows quads, each cut in two.
TriangleMesh tube(int columns, int rows, const Chart& chart);

/// Triangles of a closed surface whose chart shrinks to one point each at v = 0 and v = 1.
TriangleMesh capped_tube(int columns, int rows, const Chart& chart);

}  // namespace toile::body
