#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "sheet_grid.hpp"

namespace toile::body {

/// Values and derivatives of the four cubic B-splines that are non-zero on a cell, at t in [0, 1] of the cell:
/// row = order of the derivative (0..3), column = spline.
Eigen::Matrix4d cubic_splines(double t);

/// Tricubic B-spline on the cells of the sheets, in mm.
class SplineField {
 public:
  struct Value {
    double value = 0.0;            ///< mm
    Vec3 gradient = Vec3::Zero();  ///< dimensionless
    Mat3 hessian = Mat3::Zero();   ///< 1/mm
  };
  /// `coefficients`: one for each unknown of the grid, in cells.
  SplineField(std::shared_ptr<const SheetGrid> grid, const std::vector<double>& coefficients);
  /// By the polynomial of one cell.
  Value evaluate(int cell, const Vec3& point) const;
  const SheetGrid& grid() const { return *grid_; }

 private:
  std::shared_ptr<const SheetGrid> grid_;
  std::vector<Eigen::Matrix<double, 4, 16>> coefficients_;  ///< of each cell, those of a column along z together
};

}  // namespace toile::body
