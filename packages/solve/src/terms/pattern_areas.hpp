#pragma once

#include <vector>

#include "toile/mesh/mesh.hpp"

namespace toile::solve {

/// Integrals of the shape functions over the flat pattern: [element][node], mm^2.
std::vector<double> pattern_areas(const mesh::Mesh& mesh, const mesh::Block& block);

}  // namespace toile::solve
