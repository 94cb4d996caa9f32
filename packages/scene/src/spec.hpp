#pragma once

#include "toile/material/material.hpp"

namespace toile::scene {

/// List "Materials": one entry a fabric.
base::Spec materials_spec(const material::Laws& laws);

}  // namespace toile::scene
