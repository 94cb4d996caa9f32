#pragma once

#include "toile/base/parameters.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::scene {

/// Refuses names of panels, edges and corners in "Supports" and "Output" that are not in the mesh, which need
/// not be placed. Places behind an @ in "Points" are left to who reads them: a pattern of another size may not have
/// them, and then its size is to be told first. Throws base::InputError.
void check_nodes(const base::List& scene, const mesh::Mesh& mesh);

}  // namespace toile::scene
