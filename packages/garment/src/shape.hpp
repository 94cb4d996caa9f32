#pragma once

#include <vector>

#include "cut.hpp"
#include "toile/base/parameters.hpp"

namespace toile::garment {

/// One way of describing how a panel is cut: the parameters it adds to a panel, and what it makes of them.
struct Shape {
  base::Spec spec;
  Cut (*cut)(const base::List& panel);
  /// The user draws the outline, so it may be open, cross itself or run the wrong way round, which must be checked.
  bool drawn;
};

/// All shapes; a new one is a function of its own and a line here.
const std::vector<Shape>& shapes();

Shape outline_shape();       ///< named curves, holes, lines and notches in the scene
Shape pattern_file_shape();  ///< a panel of a file of patterns

}  // namespace toile::garment
