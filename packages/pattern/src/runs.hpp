#pragma once

#include <vector>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Parts of a line between its corners: where its tangent turns by more than `angle` (radians).
std::vector<Curve> smooth_runs(const std::vector<Segment>& segments, double angle);

/// Whether a line ends where it begins, within a distance (mm). If so, a last segment that only closes that gap is
/// dropped and the one before it ends at the beginning.
bool close_gap(std::vector<Segment>& segments, double distance);

/// Signed area of a closed line, mm^2.
double area_of(const Curve& curve);

}  // namespace toile::pattern
