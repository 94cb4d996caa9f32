#pragma once

#include "toile/solve/fields.hpp"

namespace toile::solve {

/// Fills pressure, its errors, contact_force, gap, normal and what they count, on the calling rank; position and
/// area are there already.
void add_contact_pressure(const Problem& problem, const State& state, const Accuracy& accuracy, Fields& fields);

}  // namespace toile::solve
