#pragma once

#include <vector>

#include "toile/material/material.hpp"

namespace toile::material {

/// Values [n_params] of a list that follows material_spec(): those that it gives (the first of a table), else those of
/// its set, else the defaults; NaN where a parameter has none of these.
std::vector<double> given_values(const MaterialV1& law, const base::List& list);

}  // namespace toile::material
