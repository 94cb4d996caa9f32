#pragma once

#include "toile/pattern/curve.hpp"

namespace toile::pattern {

/// Point, derivatives by the parameter t in 0..1 (mm).
Vec2 value(const Segment& segment, double t);
Vec2 derivative(const Segment& segment, double t);
Vec2 second_derivative(const Segment& segment, double t);

/// Unit tangent; at an end of a Bezier segment with a control point on it, the limit.
Vec2 direction(const Segment& segment, double t);

/// Whether it is a straight line that is run at constant speed.
bool is_line(const Segment& segment);

/// Arc length between two parameters, mm, to 1e-12 of the length of a segment that is no more bent than a half circle.
double arc_length(const Segment& segment, double from, double to);

Segment reversed(const Segment& segment);
Segment part(const Segment& segment, double from, double to);

}  // namespace toile::pattern
