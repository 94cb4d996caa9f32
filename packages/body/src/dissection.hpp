#pragma once

#include <vector>

#include "sheet_grid.hpp"

namespace toile::body {

/// Order of elimination of some of the grid's unknowns by nested dissection: planes of three layers of nodes, across
/// the limbs, part those that no cell couples. A tenth of the time of a general ordering of the matrix's graph.
std::vector<int> dissection_order(const SheetGrid& grid, std::vector<int> unknowns);

}  // namespace toile::body
