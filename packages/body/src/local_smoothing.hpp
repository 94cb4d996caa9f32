#pragma once

#include <vector>

#include "sheet_grid.hpp"

namespace toile::body {

/// Weight of the third derivatives, and less of it in folds, which would be flattened; see the README.
struct LocalSmoothing {
  std::vector<double> weights;  ///< of each cell
  std::vector<char> narrow;     ///< of each cell: it is too large for the fold in it
};

/// `smoothing`, and in folds the less the finer the facets are there beside `mean_edge` (mm).
LocalSmoothing local_smoothing(const SheetGrid& grid, const SurfaceSamples& samples, double mean_edge,
                               double smoothing);

}  // namespace toile::body
