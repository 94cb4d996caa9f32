#pragma once

#include "toile/base/parameters.hpp"
#include "toile/mesh/bent_axis.hpp"

namespace toile::garment {

/// The axis of a bent limb: parameter "axis" (points x, y, z, x, y, z, ...) of a list, its corners rounded by
/// "smoothing" (mm; 0: the shortest distance of two neighbouring points). Throws InputError.
mesh::BentAxis read_bent_axis(const base::List& list);

}  // namespace toile::garment
