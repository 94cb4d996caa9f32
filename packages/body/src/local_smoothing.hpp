#pragma once

#include <vector>

#include "sheet_grid.hpp"

namespace toile::body {

/// The weight of the third derivatives in each cell: `smoothing`, and less in folds, which would be flattened, the less
/// the finer the facets are there beside `mean_edge` (mm); see the README.
std::vector<double> local_smoothing(const SheetGrid& grid, const SurfaceSamples& samples, double mean_edge,
                                    double smoothing);

}  // namespace toile::body
