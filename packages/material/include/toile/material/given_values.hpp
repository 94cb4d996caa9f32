#pragma once

#include <vector>

#include "toile/material/material.hpp"

namespace toile::material {

/// Description of a "Material" list whose missing values will be found: as material_spec(), but no parameter is
/// required.
base::Spec fitted_material_spec(const Laws& laws);

/// Values [n_params] of a list that follows one of these descriptions: those that it gives (the first of a table), else
/// those of its set, else the defaults; NaN where a parameter has none of these.
std::vector<double> given_values(const LawV1& law, const base::List& list);

}  // namespace toile::material
