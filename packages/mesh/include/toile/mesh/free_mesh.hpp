#pragma once

#include <array>
#include <string>
#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

/// Where a free mesh is to be finer.
struct Refinement {
  std::vector<Vec2> points;  ///< round which, mm
  double size = 1.0;         ///< length of sides there, mm
  double distance = 1.0;     ///< from the points, over which the size grows to the panel's own, mm
};

/// What a free mesh is made of, and what it keeps.
struct FreeMeshInput {
  std::vector<Vec2> points;             ///< nodes that stay, those of loops and lines, mm
  std::vector<std::vector<int>> loops;  ///< closed lines through points: the outline counter-clockwise, then holes
  std::vector<std::vector<int>> lines;  ///< open lines inside that sides of elements follow
  double size = 1.0;                    ///< length of sides away from loops and refinements, mm
  std::vector<Refinement> refinements;
  bool triangles = false;  ///< else quadrilaterals, for which each loop and line has an even number of sides
};

struct FreeMesh {
  std::vector<Vec2> nodes;  ///< first the points of the input, in their order
  std::vector<std::array<int, 4>> quadrilaterals;
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise, as the quadrilaterals
};

/// Meshes an area by Gmsh's frontal Delaunay method. Quadrilaterals are made from triangles of twice the size, which a
/// perfect matching joins in pairs where it can, and a greedy one where lines leave it no way; then each quadrilateral
/// is divided into four and each triangle that is left into three, so that no triangle remains. Gmsh runs in a program
/// of its own: throws InputError if it fails, crashes, does not end within `most_seconds`, or leaves a mesh that does
/// not keep the points. Same input, same mesh.
FreeMesh mesh_freely(const FreeMeshInput& input, double most_seconds = 120.0);

}  // namespace toile::mesh
