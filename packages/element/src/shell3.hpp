#pragma once

#include "toile/element/element.hpp"

namespace toile::element {

/// Three-node shell with one in-plane point and MITC3 transverse shear, softened on coarse meshes; nodes
/// counter-clockwise in the pattern.
const Element& shell3();

}  // namespace toile::element
