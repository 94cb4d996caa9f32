#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/mesh/panel_mesh.hpp"
#include "toile/pattern/curve.hpp"

namespace toile::mesh {

using pattern::Curve;

/// Outline of a panel: bottom and top run from left to right, left and right from bottom to top.
struct FourSides {
  Curve bottom;
  Curve right;
  Curve top;
  Curve left;

  /// The two ends that should be one corner and are further apart than 1e-6 of the outline's length, as text.
  std::optional<std::string> open_corner() const;
};

/// Rectangle with its lower left corner at the origin, mm.
FourSides rectangle(double width, double height);

/// Part of a ring round the origin between two angles (radians, from < to): bottom is the outer arc and top the inner
/// one, both from `from` to `to`; left lies at `from` and right at `to`, both from the outer to the inner radius.
FourSides sector(double inner_radius, double outer_radius, double from, double to);

/// Disc round the origin whose sides are quarters of the rim between the diagonals. In the four corners two sides of an
/// element are nearly one line, but the map keeps its order: at the 2 x 2 Gauss points the smallest Jacobian is 0.68 of
/// its element's mean on any mesh, and bilinear elements solve Poisson's problem with second order (2e-5 with 64 x 64).
FourSides disc(double radius);

/// Quarter of that disc, x >= 0 and y >= 0: bottom and left are the straight sides on the axes, right and top the
/// halves of the rim. Smallest Jacobian 0.65 of its element's mean, second order as well.
FourSides quarter_disc(double radius);

struct GridOptions {
  int across = 1;  ///< elements from left to right
  int along = 1;   ///< elements from bottom to top
  bool triangles = false;
  /// Exponent g >= 1 of the node spacing: nodes at 1/2 (2t)^g from either end, 1: uniform. A displacement that behaves
  /// as r^a at the corners needs g > 1/a for the full order of linear elements in the energy.
  double grading_across = 1.0;
  double grading_along = 1.0;
  /// Random shift of the inner nodes, as a fraction of the distance to the nearest neighbour (0: none).
  double distortion = 0.0;
};

/// Structured mesh of one panel; node (i, j) is column i from the left in row j from the bottom.
struct Grid {
  int across = 0;
  int along = 0;
  std::vector<Vec2> nodes;  ///< [(along + 1) * (across + 1)] pattern coordinates, mm, row by row
  int nodes_per_element = 4;
  std::vector<int> connectivity;  ///< counter-clockwise

  int node(int i, int j) const { return j * (across + 1) + i; }
  std::vector<int> row(int j) const;     ///< nodes from left to right
  std::vector<int> column(int i) const;  ///< nodes from bottom to top
};

/// Position in 0..1 of the evenly spaced value t after symmetric grading (see GridOptions).
double graded(double t, double exponent);

/// Transfinite (Coons) map of the four sides; nodes on the sides by arc length. Quadrilaterals, or triangles by
/// alternating diagonals. Throws InputError if an element is turned over: the message names `panel` and the place.
Grid mesh_four_sided(const std::string& panel, const FourSides& sides, const GridOptions& options);

/// The grid as the mesh of a panel, with the edges "bottom", "right", "top" and "left".
PanelMesh panel_mesh(const Grid& grid);

}  // namespace toile::mesh
