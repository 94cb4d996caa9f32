#include "mitc4.hpp"

#include "rules.hpp"

namespace toile::element {

ShearSampling<4, 4, 4> mitc4() {
  ShearSampling<4, 4, 4> sampling = {{{0, 1}, {3, 2}, {0, 3}, {1, 2}}, 0.25, {}};
  for (int p = 0; p < 4; ++p) {
    const double xi = bilinear_place(p, 0), eta = bilinear_place(p, 1);
    auto& [along_xi, along_eta] = sampling.interpolation[p];
    along_xi[0] = 0.5 * (1.0 - eta);
    along_xi[1] = 0.5 * (1.0 + eta);
    along_eta[2] = 0.5 * (1.0 - xi);
    along_eta[3] = 0.5 * (1.0 + xi);
  }
  return sampling;
}

}  // namespace toile::element
