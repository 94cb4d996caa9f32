#pragma once

#include <vector>

#include "toile/scene/scene.hpp"

namespace toile::scene {

Output read_output(const base::List& list, const solve::Problem& problem);
/// Of an entry of "Distances", `parameter`: "first" or "second". Throws base::InputError if it is no edge.
int edge_node(const base::List& list, const mesh::Mesh& mesh, const std::string& parameter);
/// `with_body`: without one there is no pressure and no gap to check.
std::vector<Check> read_checks(const base::List& list, const Output& output, bool with_body);
Accuracy read_accuracy(const base::List& list, const Output& output, bool with_body);

}  // namespace toile::scene
