#pragma once

#include "polygon_soup.hpp"

namespace toile::body {

/// Points on borders that nearly coincide, without being joined by an edge.
struct NearCopies {
  int count = 0;         ///< points that have such a neighbour
  int border = 0;        ///< points on borders
  double largest = 0.0;  ///< distance of such a pair, mm
};

/// Finds them within `distance`; with `snap` each moves onto the first of its group, so that removing repeated points
/// welds them. Only borders are looked at: a closed surface is left as it is.
NearCopies near_copies(PolygonSoup* soup, double distance, bool snap);

/// Mean length of the edges that one facet uses, 0 if there is none, mm.
double mean_border_edge(const PolygonSoup& soup);

}  // namespace toile::body
