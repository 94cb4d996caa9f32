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
  /// `held`: marks unknowns that stay zero.
  NormalEquations(const SheetGrid& grid, const std::vector<char>& held);

  void add(int cell, const Matrix64& matrix);
  using Unknowns = std::vector<double>;
  /// Solves for a right-hand side, and then for `next(first solution)`, with one factorisation; `ridge` is added to the
  /// diagonal. Throws InputError if the matrix cannot be factorised.
  std::array<Unknowns, 2> solve(double ridge, const Unknowns& right,
                                const std::function<Unknowns(const Unknowns&)>& next) const;

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
  Unknowns of_free(const Unknowns& all) const;
  Unknowns of_all(const Unknowns& free) const;

  const SheetGrid& grid_;
  std::vector<int> free_;    ///< unknowns that are not held; what is stored is theirs, in this order
  std::vector<int> number_;  ///< of each unknown among them, -1: held
  std::vector<int> others_;  ///< of each free unknown, that at each stored offset; -1: none
  std::vector<double> values_;
  std::vector<Extra> extras_;
};

}  // namespace toile::body
