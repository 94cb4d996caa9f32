#pragma once

#include "toile/element/element.hpp"

namespace toile::element {

/// Bilinear quadrilateral, 2 x 2 Gauss points; nodes counter-clockwise in the pattern.
const Element& membrane4();

}  // namespace toile::element
