#pragma once

#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

const StageKind& sew_stage();

}  // namespace toile::solve
