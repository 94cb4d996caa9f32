#pragma once

#include "toile/base/origins.hpp"
#include "toile/base/parameters.hpp"

namespace toile::garment {

/// Description of the list "Pattern": a whole garment from one file of patterns.
base::Spec pattern_spec();

/// Completes a scene by its list "Pattern", if it has one: each panel of the file becomes an entry of "Panels" and each
/// stitch one of "Seams". What an entry of the same name says goes before. Throws InputError for a list that is wrong
/// and a file that cannot be read.
void add_pattern(Teuchos::ParameterList& scene, base::Origins& origins);

}  // namespace toile::garment
