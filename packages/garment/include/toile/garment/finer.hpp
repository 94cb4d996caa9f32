#pragma once

#include "toile/base/parameters.hpp"

namespace toile::garment {

/// The parameter "finer" of a scene.
base::Parameter finer_parameter();

/// Divides the sizes of elements of all panels by the scene's parameter "finer", before the scene is validated: counts
/// along sides times it, rounded, at least 1. What is no number stays, for the validation to tell.
void make_finer(Teuchos::ParameterList& scene);

}  // namespace toile::garment
