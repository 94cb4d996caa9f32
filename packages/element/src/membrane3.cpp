#include "membrane3.hpp"

#include "membrane.hpp"

namespace toile::element {
namespace {

constexpr double third = 1.0 / 3.0;

/// Area coordinates of the parent triangle (0, 0), (1, 0), (0, 1) at its centroid.
constexpr Rule<3, 1> linear = {{{third, third, third}}, {{{-1.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}}}, {0.5}};

}  // namespace

const Element& membrane3() {
  static const Membrane<3, 1> element("membrane3", "linear triangular membrane, one point", linear);
  return element;
}

}  // namespace toile::element
