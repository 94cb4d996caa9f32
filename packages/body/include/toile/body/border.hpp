#pragma once

#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Marks the vertices on a border: those of edges that belong to one facet alone.
std::vector<char> border_vertices(const TriangleMesh& mesh);

}  // namespace toile::body
