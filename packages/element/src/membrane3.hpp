#pragma once

#include "toile/element/element.hpp"

namespace toile::element {

/// Linear triangle, one point; nodes counter-clockwise in the pattern.
const Element& membrane3();

}  // namespace toile::element
