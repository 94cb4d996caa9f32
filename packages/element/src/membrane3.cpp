#include "membrane3.hpp"

#include "membrane.hpp"
#include "rules.hpp"

namespace toile::element {

const Element& membrane3() {
  static const Membrane<3, 1> element("membrane3", "linear triangular membrane, one point", linear());
  return element;
}

}  // namespace toile::element
