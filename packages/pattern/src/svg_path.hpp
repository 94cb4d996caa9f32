#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "toile/pattern/curve.hpp"

namespace toile::pattern {

/// Part of an SVG path between two "move to".
struct SubPath {
  std::vector<Segment> segments;
  bool closed = false;
};

/// Segments of an SVG path's data (attribute `d`), in its own units. Throws InputError with the place in the text.
std::vector<SubPath> parse_path(const std::string& text);

/// What an SVG attribute `transform` says. Throws InputError.
Eigen::Affine2d parse_transform(const std::string& text);

/// The numbers of an SVG attribute such as `points` or `viewBox`. Throws InputError.
std::vector<double> parse_numbers(const std::string& text);

/// Segments under an affine map. Exact; an arc of a circle that becomes one of an ellipse is followed by cubic segments
/// to 1e-7 of its size.
std::vector<Segment> transformed(const std::vector<Segment>& segments, const Eigen::Affine2d& map);

}  // namespace toile::pattern
