#pragma once

#include "toile/base/parameters.hpp"
#include "toile/solve/options.hpp"

namespace toile::solve {

/// Parameters that every kind of stage has.
base::Spec stage_spec(const std::string& name, const std::string& text);
void read_stage(const base::List& list, StageOptions& stage);

/// Those of a stage that goes step by step.
void add_steps(base::Spec& spec);
void read_steps(const base::List& list, StageOptions& stage);

/// List "Damping".
base::Spec damping_spec();
void read_damping(const base::List& list, StageOptions& stage);

}  // namespace toile::solve
