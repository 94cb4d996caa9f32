#pragma once

#include "toile/element/element.hpp"

namespace toile::element {

/// Four-node shell with one in-plane point, physical stabilisation and MITC4 transverse shear; nodes counter-clockwise
/// in the pattern.
const Element& shell4r();

}  // namespace toile::element
