#pragma once

#include <functional>

#include "equilibrium/types.hpp"

namespace toile::solve {

/// The unit vector x with the smallest |x.Ax| of a symmetric matrix A, given x = A^-1 b, which returns false without a
/// solution. Null: there was none, or no unknown. It starts from the same vector on any number of ranks. Collective.
RCP<Vector> inverse_iterations(const RCP<const Map>& map, const std::function<bool(const Vector& b, Vector& x)>& solve);

}  // namespace toile::solve
