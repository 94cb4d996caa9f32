#include "membrane4.hpp"

#include "membrane.hpp"
#include "rules.hpp"

namespace toile::element {

const Element& membrane4() {
  static const Membrane<4, 4> element("membrane4", "bilinear quadrilateral membrane, 2 x 2 points", bilinear());
  return element;
}

}  // namespace toile::element
