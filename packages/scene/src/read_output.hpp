#pragma once

#include <vector>

#include "toile/scene/scene.hpp"

namespace toile::scene {

Output read_output(const base::List& list, const solve::Problem& problem);
/// `with_body`: without one there is no pressure and no gap to check.
std::vector<Check> read_checks(const base::List& list, const Output& output, bool with_body);
Accuracy read_accuracy(const base::List& list, const Output& output, bool with_body);

}  // namespace toile::scene
