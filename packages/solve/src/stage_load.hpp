#pragma once

#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

const StageKind& load_stage();

}  // namespace toile::solve
