#include "shell4r.hpp"

#include "mitc4.hpp"
#include "rules.hpp"
#include "shell.hpp"

namespace toile::element {

const Element& shell4r() {
  static const Shell<4, 4, 1, 4, Hourglass> element("shell4r", "four-node shell, one point, physical stabilisation",
                                                    {bilinear_centre(), bilinear(), mitc4()});
  return element;
}

}  // namespace toile::element
