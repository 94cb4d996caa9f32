#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

#include "sheet_grid.hpp"

namespace toile::body {

using Matrix64 = Eigen::Matrix<double, 64, 64>;
using Vector64 = Eigen::Matrix<double, 64, 1>;

/// Sparse, symmetric equations for the coefficients of a spline on the cells of a grid.
class NormalEquations {
 public:
  explicit NormalEquations(const SheetGrid& grid);

  void add(int cell, const Matrix64& matrix);
  void add(int cell, const Vector64& right);
  /// Solves for what was added as right-hand side, and then for `next(first solution)`, with one factorisation; `ridge`
  /// is added to the diagonal. Throws InputError if the matrix cannot be factorised.
  std::array<std::vector<double>, 2> solve(
      double ridge, const std::function<std::vector<double>(const std::vector<double>&)>& next) const;

 private:
  /// Coupling of an unknown with one that is neither itself nor stored in its row of `values_`: where sheets part, two
  /// unknowns can lie at the same offset.
  struct Extra {
    int row = 0;
    int column = 0;
    double value = 0.0;
  };
  void add(int a, int b, int offset, double value);
  std::vector<Extra> merged_extras() const;

  const SheetGrid& grid_;
  std::vector<double> right_;
  std::vector<int> others_;  ///< of each unknown, that at each stored offset; -1: none
  std::vector<double> values_;
  std::vector<Extra> extras_;
};

}  // namespace toile::body
