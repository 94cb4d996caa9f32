#pragma once

#include <set>
#include <string>
#include <vector>

#include "toile/pattern/panel.hpp"

namespace toile::garment {

/// How a panel is cut.
struct Cut {
  pattern::Panel panel;             ///< mm; its edges run in the direction in which places on them are counted
  std::set<std::string> backwards;  ///< edges that the outline passes from their end to their start

  /// The panel with all edges in the direction of the outline.
  pattern::Panel along_outline() const;
};

}  // namespace toile::garment
