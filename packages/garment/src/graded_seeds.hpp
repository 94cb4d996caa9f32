#pragma once

#include "seeds.hpp"

namespace toile::garment {

/// How many pairs of sides of the wanted length an edge holds between two relative arc lengths.
double wanted_pairs(const SeededEdge& edge, double from, double to);

/// Places between two relative arc lengths (both left out) that divide an edge into pairs of sides of the wanted
/// length; none if that length is the same all the way.
Fractions graded_places(const SeededEdge& edge, double from, double to);

}  // namespace toile::garment
