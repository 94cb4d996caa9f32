#include "scaled.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace toile::dress {
namespace {

using pattern::Curve;

/// Turned by an angle about the pattern's origin, and scaled.
struct Change {
  double factor, angle;
  pattern::Vec2 operator()(const pattern::Vec2& at) const { return factor * (Eigen::Rotation2Dd(angle) * at); }
};

Curve changed(const Curve& curve, const Change& change) {
  std::vector<pattern::Segment> segments = curve.segments();
  for (pattern::Segment& segment : segments) {
    if (auto* bezier = std::get_if<pattern::Bezier>(&segment)) {
      for (pattern::Vec2& control : bezier->control) control = change(control);
    } else {
      auto& arc = std::get<pattern::Arc>(segment);
      arc.centre = change(arc.centre);
      arc.radius *= change.factor;
      arc.from += change.angle;
      arc.to += change.angle;
    }
  }
  return Curve(std::move(segments));
}

void make(pattern::Panel& panel, const Change& change) {
  const auto in_loop = [&](pattern::Loop& loop) {
    for (pattern::Edge& edge : loop) edge.curve = changed(edge.curve, change);
  };
  in_loop(panel.outline);
  for (pattern::Loop& hole : panel.holes) in_loop(hole);
  for (pattern::InternalLine& line : panel.lines) line.curve = changed(line.curve, change);
  if (panel.grain) panel.grain = pattern::Grain{change(panel.grain->from), change(panel.grain->to)};
}

}  // namespace

pattern::Pattern scaled(const pattern::Pattern& pattern, double factor) {
  pattern::Pattern result = pattern;
  for (pattern::Panel& panel : result.panels) {
    make(panel, {factor, 0.0});
    if (panel.placement) panel.placement->translation *= factor;
  }
  return result;
}

void turn(pattern::Panel& panel, double angle) {
  make(panel, {1.0, angle});
}

}  // namespace toile::dress
