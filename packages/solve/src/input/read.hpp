#pragma once

#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/mesh/mesh.hpp"
#include "toile/solve/problem.hpp"

namespace toile::solve {

/// Nodes of the corner, place, edge or panel that parameter "on" of the list calls `name`. Throws base::InputError.
std::vector<int> read_nodes(const base::List& list, const mesh::Mesh& mesh, const std::string& name);
/// The array of three numbers named `name`. Throws base::InputError if it has another length.
Vec3 read_vector(const base::List& list, const std::string& name);

}  // namespace toile::solve
