#pragma once

#include "toile/base/parameters.hpp"

namespace toile::study {

/// Description of a study file.
base::Spec study_spec();

}  // namespace toile::study
