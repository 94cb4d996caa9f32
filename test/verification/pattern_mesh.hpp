// Meshes of a rectangle whose left and right sides are sewn: regular, turned against the sides, distorted, free.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace toile::test {

/// Nodes beyond x = width repeat those at its beginning: they are tied to them.
struct PatternMesh {
  std::vector<Eigen::Vector2d> nodes;  ///< mm
  std::vector<int> tied_to;            ///< [node] itself, or the node one width away
  std::vector<std::array<int, 4>> quadrilaterals;
  std::vector<std::array<int, 3>> triangles;
};

/// The eight kinds: "aligned", "turned" (a square lattice at 30 degrees), "shifted" (nodes by up to 25 % of their
/// distance), "triangles", "quadrilaterals", "mixed" (free triangles and quadrilaterals beside each other), "graded
/// triangles", "graded quadrilaterals" (1 : 3, abrupt).
const std::vector<std::string>& mesh_kinds();

/// Height in y, from 0; `size`: mean length of an element's side, mm; of graded ones size / sqrt(3) and sqrt(3)
/// size.
PatternMesh pattern_mesh(const std::string& kind, double width, double height, double size);

}  // namespace toile::test
