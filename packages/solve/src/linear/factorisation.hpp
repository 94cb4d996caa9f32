#pragma once

#include <memory>

#include "equilibrium/types.hpp"

namespace toile::solve {

/// Sparse LDLt factorisation by MUMPS of symmetric distributed matrices of one graph, which is analysed once.
class Factorisation {
 public:
  explicit Factorisation(const Matrix& matrix);
  ~Factorisation();
  Factorisation(const Factorisation&) = delete;
  Factorisation& operator=(const Factorisation&) = delete;

  /// Whether the matrix has the graph of the first one, on all ranks. Collective.
  bool fits(const Matrix& matrix) const;
  /// Factorises the matrix's present values. Returns false if MUMPS could not (singular to its eyes).
  bool factorise(const Matrix& matrix);
  int negative_pivots() const;
  /// x = A^-1 b; both on the matrix's row map.
  void solve(const MultiVector& b, MultiVector& x) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace toile::solve
