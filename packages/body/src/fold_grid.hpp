#pragma once

#include <vector>

#include "sheet_grid.hpp"
#include "surface_samples.hpp"

namespace toile::body {

/// Cells of half the size in folds that are too narrow for the cells of the whole body. A spline on them that is added
/// to that of the whole body vanishes, with its first and second derivatives, where the folds end.
class FoldGrid {
 public:
  /// `narrow`: marks the cells of `whole` that are too large for the fold in them. `samples`: of the mesh, those of
  /// `whole`. Throws InputError if the box round the folds has too many cells.
  FoldGrid(const TriangleMesh& mesh, const SurfaceSamples& samples, const SheetGrid& whole,
           const std::vector<char>& narrow);

  const SheetGrid& grid() const { return grid_; }
  /// Facets in and round the folds, with all vertices of the mesh.
  const TriangleMesh& facets() const { return facets_; }
  /// Cell at a place of the mesh; -1: none.
  int cell_at(int triangle, const Vec3& barycentric, const Vec3& point) const;
  /// Cell of the whole body of the same sheet that holds the cell; -1: none.
  int whole_cell(int cell) const { return whole_cells_[cell]; }
  /// Marks the unknowns that reach out of the folds.
  std::vector<char> held() const;
  /// Cells in the folds.
  int inside() const;

 private:
  std::vector<int> facet_of_;  ///< of each triangle of the mesh, that of facets_; -1: none
  TriangleMesh facets_;
  SurfaceSamples samples_;
  SheetGrid grid_;
  std::vector<int> whole_cells_;
  std::vector<char> inside_;  ///< of each cell
};

}  // namespace toile::body
