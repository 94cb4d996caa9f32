#pragma once

#include "toile/pattern/panel.hpp"

namespace toile::dress {

/// The pattern and its places in space, `factor` times as large.
pattern::Pattern scaled(const pattern::Pattern& pattern, double factor);

/// Turns a panel in its pattern, counter-clockwise (rad); its placement stays.
void turn(pattern::Panel& panel, double angle);

}  // namespace toile::dress
