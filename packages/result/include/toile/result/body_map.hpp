#pragma once

#include <vector>

#include "toile/body/surface.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::result {

struct BodyMapOptions {
  double limit = 5.0;      ///< mm; how far from the body the garment may be, in addition to its gap there
  double agreement = 0.5;  ///< smallest cosine between the normals of body and garment
};

/// A nodal field of the deformed garment (for instance the contact pressure) on the body's vertices: linear
/// interpolation at the closest point of the garment, zero where no garment lies over the body.
///
/// No garment lies over a vertex if the closest point is further than limit + gap, if the normals disagree (the other
/// leg's garment) or if the point lies beside the vertex (beyond a free edge). Which side of a panel faces the body is
/// found per block, from the majority of vertices.
///
/// `position`: [node] mm; `values`: [node]; `gap`: [node] mm between body and garment, without the fabric's offset.
/// Returns [body vertex], unit of `values`.
std::vector<double> map_to_body(const mesh::Mesh& garment, const std::vector<mesh::Vec3>& position,
                                const std::vector<double>& values, const std::vector<double>& gap,
                                const body::TriangleMesh& body, const BodyMapOptions& options = {});

}  // namespace toile::result
