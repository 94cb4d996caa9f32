#include "svg_layout.hpp"

#include <algorithm>
#include <cmath>

namespace toile::pattern {
namespace {

constexpr double gap = 20.0;       ///< between panels and to the border, mm
constexpr double closeness = 0.1;  ///< of the points that a box is taken from, mm

/// Round a panel in the drawing's direction of y, its (0, 0) at (0, 0).
Box box_of(const Panel& panel) {
  Box box{Vec2::Constant(1e300), Vec2::Constant(-1e300)};
  for (const Edge& edge : panel.outline)
    for (const Vec2& p : edge.curve.points(closeness)) {
      const Vec2 q(p.x(), -p.y());
      box.low = box.low.cwiseMin(q);
      box.high = box.high.cwiseMax(q);
    }
  return box;
}

}  // namespace

Layout lay_out(const Pattern& pattern) {
  Layout layout;
  double area = 0.0, widest = 0.0;
  for (const Panel& panel : pattern.panels) {
    layout.boxes.push_back(box_of(panel));
    const Vec2 size = layout.boxes.back().high - layout.boxes.back().low;
    area += (size.x() + gap) * (size.y() + gap);
    widest = std::max(widest, size.x());
  }
  const double width = std::max(widest + 2.0 * gap, 1.3 * std::sqrt(area));
  Vec2 at(gap, gap);
  double bottom = gap;
  for (Box& box : layout.boxes) {
    const Vec2 size = box.high - box.low;
    if (at.x() > gap && at.x() + size.x() + gap > width) at = Vec2(gap, bottom + gap);
    layout.origins.push_back(at - box.low);
    box = {at, at + size};
    at.x() += size.x() + gap;
    bottom = std::max(bottom, box.high.y());
    layout.size.x() = std::max(layout.size.x(), at.x());
  }
  layout.size.y() = bottom + gap;
  return layout;
}

bool meets(const Box& a, const Box& b) {
  return (a.low.array() < b.high.array()).all() && (b.low.array() < a.high.array()).all();
}

}  // namespace toile::pattern
