#pragma once

#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/mesh/four_sided.hpp"

namespace toile::garment {

/// One way of describing a panel's outline: the parameters it adds to a panel, and the sides it makes of them.
struct Shape {
  base::Spec spec;
  mesh::FourSides (*sides)(const base::List& panel);
  /// The user draws the outline, so it may be open, cross itself or run the wrong way round, which must be checked.
  bool drawn;
};

/// All shapes; a new one is a function of its own and a line here.
const std::vector<Shape>& shapes();

}  // namespace toile::garment
