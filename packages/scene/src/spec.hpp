#pragma once

#include "toile/base/parameters.hpp"

namespace toile::scene {

/// List "Materials": one entry a fabric.
base::Spec materials_spec();

}  // namespace toile::scene
