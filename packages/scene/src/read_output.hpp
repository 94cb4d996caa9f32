#pragma once

#include <vector>

#include "toile/scene/scene.hpp"

namespace toile::scene {

Output read_output(const base::List& list, const solve::Problem& problem);
std::vector<Check> read_checks(const base::List& list);

}  // namespace toile::scene
