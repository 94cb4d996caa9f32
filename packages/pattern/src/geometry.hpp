#pragma once

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Signed area that a loop encloses, mm^2; positive: counter-clockwise.
double signed_area(const Loop& loop);

/// Whether a point lies on the fabric within a panel's outline.
bool lies_on(const Panel& panel, const Vec2& point);

/// Why the outline and the holes of a panel bound no piece of fabric, with the place: lines that cross or touch, a hole
/// outside. Empty if they do. Loops must be closed and oriented.
std::string why_invalid(const Panel& panel);

/// Where an internal line leaves the panel or crosses another one; empty: nowhere.
std::string problem_of_lines(const Panel& panel);

}  // namespace toile::pattern
