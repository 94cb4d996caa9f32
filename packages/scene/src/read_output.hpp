#pragma once

#include <vector>

#include "toile/scene/scene.hpp"

namespace toile::scene {

/// Of a list that may be missing.
std::vector<base::List> entries_of(const base::List& list, const std::string& name);
base::Texts names_of(const base::List& list, const std::string& name);

/// Of the list "Output" what needs neither the garment nor the body, so that it can be refused before they are there.
/// `scene`: the outermost list, here and below.
Output read_output(const base::List& scene);
/// Adds the rest: what lies on the garment and on the body. `list`: "Output".
void find_places(const base::List& list, const solve::Problem& problem, Output& output);
/// Of an entry of "Distances", `parameter`: "first" or "second". Throws base::InputError if it is no edge.
mesh::EdgePlace place_on_edge(const base::List& list, const mesh::Mesh& mesh, const std::string& parameter);
/// `output`: what read_output found.
std::vector<Check> read_checks(const base::List& scene, const Output& output);
Accuracy read_accuracy(const base::List& scene);

}  // namespace toile::scene
