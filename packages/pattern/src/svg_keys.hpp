#pragma once

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Attributes by which drawings of ours tell what an element is. Kinds: panel, edge, line, notch, grain, stitch, and
/// drawing for what only people read.
namespace svg_key {
constexpr const char* kind = "data-toile";
constexpr const char* name = "data-name";
constexpr const char* hole = "data-hole";            ///< number of the hole that an edge bounds
constexpr const char* edge = "data-edge";            ///< of a notch
constexpr const char* at = "data-at";                ///< of a notch, relative arc length
constexpr const char* origin = "data-origin";        ///< where the panel's (0, 0) lies on the drawing
constexpr const char* placement = "data-placement";  ///< rotation by rows, translation
constexpr const char* first = "data-first";
constexpr const char* second = "data-second";
constexpr const char* reversed = "data-reversed";
}  // namespace svg_key

Pattern read_svg(const std::string& path);

}  // namespace toile::pattern
