#pragma once

#include <vector>

#include "place.hpp"

namespace toile::dress {

/// Of the trunk between hem and armholes, then of each sleeve between the ends of its cap and its cuff.
std::vector<Girth> girths_of(const Placed& placed, const Wearer& wearer);

/// The one with the largest stretch. Throws InputError if none has a body inside.
Girth tightest_of(const std::vector<Girth>& girths);

}  // namespace toile::dress
