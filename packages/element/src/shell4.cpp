#include "shell4.hpp"

#include "mitc4.hpp"
#include "rules.hpp"
#include "shell.hpp"

namespace toile::element {

const Element& shell4() {
  static const Shell<4, 4, 4, 4, NoStabilisation> element("shell4", "four-node shell, 2 x 2 points, assumed shear",
                                                          {bilinear(), bilinear(), mitc4()});
  return element;
}

}  // namespace toile::element
