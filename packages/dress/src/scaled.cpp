#include "scaled.hpp"

namespace toile::dress {
namespace {

using pattern::Curve;

Curve scaled(const Curve& curve, double factor) {
  std::vector<pattern::Segment> segments = curve.segments();
  for (pattern::Segment& segment : segments) {
    if (auto* bezier = std::get_if<pattern::Bezier>(&segment)) {
      for (pattern::Vec2& control : bezier->control) control *= factor;
    } else {
      auto& arc = std::get<pattern::Arc>(segment);
      arc.centre *= factor;
      arc.radius *= factor;
    }
  }
  return Curve(std::move(segments));
}

void scale(pattern::Loop& loop, double factor) {
  for (pattern::Edge& edge : loop) edge.curve = scaled(edge.curve, factor);
}

}  // namespace

pattern::Pattern scaled(const pattern::Pattern& pattern, double factor) {
  pattern::Pattern result = pattern;
  for (pattern::Panel& panel : result.panels) {
    scale(panel.outline, factor);
    for (pattern::Loop& hole : panel.holes) scale(hole, factor);
    for (pattern::InternalLine& line : panel.lines) line.curve = scaled(line.curve, factor);
    if (panel.grain) panel.grain = pattern::Grain{factor * panel.grain->from, factor * panel.grain->to};
    if (panel.placement) panel.placement->translation *= factor;
  }
  return result;
}

}  // namespace toile::dress
