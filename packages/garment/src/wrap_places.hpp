#pragma once

#include <utility>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/mesh/panel_mesh.hpp"

namespace toile::garment {

/// Where a node lies on a wrap.
struct WrapPlace {
  double height = 0.0;    ///< along the axis, mm
  double width = 0.0;     ///< of the pattern at this height, mm
  double fraction = 0.0;  ///< of the width from its left end to the node
  bool is_level = false;  ///< all nodes of its row lie at this height
};

struct WrapPlaces {
  std::vector<WrapPlace> node;
  double spacing = 1.0;                     ///< mm of height between sections that are fine enough for all nodes
  std::vector<std::pair<int, int>> rising;  ///< lines between nodes that must rise along the axis
};

/// Heights of the panel's bottom and top along the axis. Throws InputError.
std::pair<double, double> wrap_heights(const base::List& list);

/// Of a mesh in rows: heights are linear in the pattern coordinate y of the node, or with "rows" = level in the mean of
/// its row. A row that is straight has one height, without round-off.
WrapPlaces places_in_rows(const base::List& list, const mesh::PanelMesh& flat);

/// Of any mesh: heights are linear in the pattern coordinate y; the width is that of the outline at this y, from its
/// left to its right end.
WrapPlaces places_by_width(const base::List& list, const mesh::PanelMesh& flat);

/// Gives all nodes the greatest width of the pattern, and their part of it by x alone.
void widen(const mesh::PanelMesh& flat, WrapPlaces& places);

}  // namespace toile::garment
