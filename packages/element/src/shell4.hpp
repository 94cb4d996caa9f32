#pragma once

#include "toile/element/element.hpp"

namespace toile::element {

/// Four-node shell with 2 x 2 in-plane points and MITC4 transverse shear; nodes counter-clockwise in the pattern.
const Element& shell4();

}  // namespace toile::element
