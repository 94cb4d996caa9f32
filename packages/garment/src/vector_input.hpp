#pragma once

#include <string>

#include "toile/base/parameters.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::garment {

/// The array of three numbers named `name`. Throws InputError if it has another length.
mesh::Vec3 read_vector(const base::List& list, const std::string& name);
/// The same scaled to length one. Throws InputError if it is zero.
mesh::Vec3 read_direction(const base::List& list, const std::string& name);
/// The part of it that is perpendicular to the unit vector `axis`, scaled to length one. Throws InputError if it is
/// parallel.
mesh::Vec3 read_perpendicular(const base::List& list, const std::string& name, const mesh::Vec3& axis);

}  // namespace toile::garment
