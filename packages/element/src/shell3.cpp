#include "shell3.hpp"

#include "rules.hpp"
#include "shell.hpp"

namespace toile::element {
namespace {

/// MITC3 (Lee and Bathe, Comput. Struct. 82 (2004) 945-962): the tangential shear e_12, e_13, e_23 of the edges, and
/// with c = e_13 - e_12 - e_23 the covariant components e_12 + c s and e_13 - c r.
ShearSampling<3, 3, 3> mitc3() {
  ShearSampling<3, 3, 3> sampling = {{{0, 1}, {0, 2}, {1, 2}}, 0.5, {}};
  for (int p = 0; p < 3; ++p) {
    const double r = linear_place(p, 0), s = linear_place(p, 1);
    auto& [along_r, along_s] = sampling.interpolation[p];
    along_r[0] = 1.0 - s;
    along_r[1] = s;
    along_r[2] = -s;
    along_s[0] = r;
    along_s[1] = 1.0 - r;
    along_s[2] = r;
  }
  return sampling;
}

}  // namespace

const Element& shell3() {
  static const Shell<3, 3, 1, 3, SoftShear> element("shell3", "three-node shell, one point, softened assumed shear",
                                                    {linear(), linear_three_points(), mitc3()});
  return element;
}

}  // namespace toile::element
