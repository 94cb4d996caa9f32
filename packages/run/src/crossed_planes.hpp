#pragma once

#include <string>
#include <vector>

#include "toile/solve/problem.hpp"

namespace toile::run {

/// Whether fabric has passed through the plane in which the support holds its edge, said with depth and place (mm);
/// empty: it has not, the support holds no plane, or the plane ran through the fabric from the beginning. `position`:
/// [node].
///
/// If that is a plane of symmetry, as of half a garment, the fabric has passed through its own mirror image, which no
/// part of the program prevents.
std::string crossed_plane(const solve::Support& support, const mesh::Mesh& mesh,
                          const std::vector<solve::Vec3>& position);

}  // namespace toile::run
