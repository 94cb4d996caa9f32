#include "ring.hpp"

namespace toile::pattern {

Polygon::ring_type ring(const Loop& loop) {
  double length = 0.0;
  for (const Edge& edge : loop) length += edge.curve.length();
  Polygon::ring_type points;
  for (const Edge& edge : loop) {
    const std::vector<Vec2> curve = edge.curve.points(chord * length);
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) points.emplace_back(curve[k].x(), curve[k].y());
  }
  if (!points.empty()) points.push_back(points.front());
  return points;
}

Polygon polygon_of(const Panel& panel) {
  Polygon polygon{ring(panel.outline)};
  for (const Loop& hole : panel.holes) polygon.inners().push_back(ring(hole));
  return polygon;
}

}  // namespace toile::pattern
