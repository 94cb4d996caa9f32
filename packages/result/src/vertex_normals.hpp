#pragma once

#include <vector>

#include "toile/body/surface.hpp"

namespace toile::result {

/// [vertex] unit normal, of its triangles weighted by their area.
std::vector<body::Vec3> vertex_normals(const body::TriangleMesh& mesh);

}  // namespace toile::result
