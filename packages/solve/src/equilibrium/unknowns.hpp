#pragma once

#include <vector>

#include "equilibrium/layout.hpp"
#include "toile/solve/checkpoint.hpp"

namespace toile::solve {

/// The vector of unknowns of a state.
RCP<Vector> vector_of(const Layout& layout, const State& state);

/// The values of a vector of unknowns, and the vector of such values; null of none. Collective.
Unknowns gather(const Layout& layout, const Problem& problem, const Vector& z);
RCP<Vector> scatter(const Layout& layout, const Problem& problem, const Unknowns& all);

/// Of each value over the ranks. Collective.
std::vector<double> sum_over_ranks(const Comm& comm, const std::vector<double>& mine);

}  // namespace toile::solve
