#pragma once

#include <vector>

#include "toile/body/surface.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::result {

/// The deformed garment as triangles: quadrilaterals are split about their centre, which keeps their symmetry.
/// Vertices are the nodes, then one centre a quadrilateral.
struct GarmentTriangles {
  body::TriangleMesh mesh;
  std::vector<int> element;  ///< [triangle] garment element
  std::vector<int> block;    ///< [triangle]
};

GarmentTriangles triangulate(const mesh::Mesh& garment, const std::vector<mesh::Vec3>& position);

/// Nodal values continued to the centres of the quadrilaterals: [vertex].
std::vector<double> at_vertices(const mesh::Mesh& garment, const std::vector<double>& nodal);
std::vector<mesh::Vec3> at_vertices(const mesh::Mesh& garment, const std::vector<mesh::Vec3>& nodal);

}  // namespace toile::result
