// Moves the panels of a pattern to where they start beside the body.
#pragma once

#include <vector>

#include "parts.hpp"
#include "toile/dress/dress.hpp"
#include "wearer.hpp"

namespace toile::dress {

/// A garment whose panels have their start.
struct Placed {
  pattern::Pattern pattern;
  std::vector<Part> parts;
  std::vector<Wrap> wraps;
  std::vector<std::string> hems;                       ///< "panel.edge"
  double lowest = 0.0, highest = 0.0, underarm = 0.0;  ///< of the trunk: heights of hem, top and armholes, mm
};

/// `pattern` is scaled. Throws InputError if nothing says how high it starts.
Placed place(const pattern::Pattern& pattern, const Wearer& wearer, const Options& options);

/// Direction from the cap of a sleeve to its cuff, and the highest point of the cap. Throws InputError for a sleeve
/// that is not sewn to the trunk, or has no free edge.
struct SleeveShape {
  Vec3 top, direction;  ///< mm; unit
};
SleeveShape shape_of_sleeve(const Placed& placed, int side);

}  // namespace toile::dress
