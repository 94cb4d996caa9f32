#pragma once

#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::drape {

/// [node] unit normal of the placed elements around it, on the right side of the fabric.
std::vector<mesh::Vec3> nodal_normals(const mesh::Mesh& mesh);

}  // namespace toile::drape
