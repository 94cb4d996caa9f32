#pragma once

#include <vector>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

/// Upright rectangle on a drawing, mm.
struct Box {
  Vec2 low, high;
};

/// Where the panels stand on a drawing, whose y axis points down, mm.
struct Layout {
  std::vector<Vec2> origins;  ///< of each panel's (0, 0)
  std::vector<Box> boxes;     ///< round each panel
  Vec2 size = Vec2::Zero();
};

/// Panels in rows, in their order.
Layout lay_out(const Pattern& pattern);

bool meets(const Box& a, const Box& b);

}  // namespace toile::pattern
