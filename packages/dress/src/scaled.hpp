#pragma once

#include "toile/pattern/panel.hpp"

namespace toile::dress {

/// The pattern and its places in space, `factor` times as large.
pattern::Pattern scaled(const pattern::Pattern& pattern, double factor);

}  // namespace toile::dress
