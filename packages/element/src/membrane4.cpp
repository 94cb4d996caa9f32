#include "membrane4.hpp"

#include "membrane.hpp"

namespace toile::element {
namespace {

/// Bilinear shape functions on [-1, 1]^2 at the 2 x 2 Gauss points; point p lies nearest to node p.
Rule<4, 4> bilinear() {
  const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double gauss = 1.0 / std::sqrt(3.0);
  Rule<4, 4> rule;
  for (int p = 0; p < 4; ++p) {
    const double xi = gauss * corner[p][0], eta = gauss * corner[p][1];
    rule.weight[p] = 1.0;
    for (int i = 0; i < 4; ++i) {
      const double along_xi = 1.0 + corner[i][0] * xi, along_eta = 1.0 + corner[i][1] * eta;
      rule.N[p][i] = 0.25 * along_xi * along_eta;
      rule.dN[p][i][0] = 0.25 * corner[i][0] * along_eta;
      rule.dN[p][i][1] = 0.25 * corner[i][1] * along_xi;
    }
  }
  return rule;
}

}  // namespace

const Element& membrane4() {
  static const Membrane<4, 4> element("membrane4", "bilinear quadrilateral membrane, 2 x 2 points", bilinear());
  return element;
}

}  // namespace toile::element
