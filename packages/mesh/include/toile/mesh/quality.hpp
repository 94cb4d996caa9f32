#pragma once

#include <string>

#include "toile/mesh/panel_mesh.hpp"

namespace toile::mesh {

/// The worst of all elements of a panel.
struct Quality {
  double smallest_angle = 180.0;   ///< degrees
  double largest_angle = 0.0;      ///< degrees
  double smallest_jacobian = 1.0;  ///< of a corner over the largest of its element; 1: a parallelogram
  double largest_aspect = 1.0;     ///< longest over shortest side of an element
  Vec2 worst = Vec2::Zero();       ///< centre of the element with the smallest angle, mm of the pattern
};

Quality quality_of(const PanelMesh& panel);
/// Of a panel of the garment, by its number.
Quality quality_of(const Mesh& mesh, int panel);

}  // namespace toile::mesh
