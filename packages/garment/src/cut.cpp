#include "cut.hpp"

namespace toile::garment {

pattern::Panel Cut::along_outline() const {
  pattern::Panel turned = panel;
  for (pattern::Edge& edge : turned.outline)
    if (backwards.count(edge.name) > 0) edge.curve = edge.curve.reversed();
  for (pattern::Notch& notch : turned.notches)
    if (backwards.count(notch.edge) > 0) notch.at = 1.0 - notch.at;
  return turned;
}

}  // namespace toile::garment
