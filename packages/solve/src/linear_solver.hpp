#pragma once

#include <memory>
#include <string>

#include "toile/solve/options.hpp"
#include "types.hpp"

namespace toile::solve {

/// Sparse LDLt factorisation of a symmetric distributed matrix by MUMPS.
class Factorisation {
 public:
  explicit Factorisation(const Matrix& matrix);
  ~Factorisation();
  Factorisation(const Factorisation&) = delete;
  Factorisation& operator=(const Factorisation&) = delete;

  /// Factorises the matrix's present values. Returns false if MUMPS could not (singular to its eyes).
  bool factorise(const Matrix& matrix);
  int negative_pivots() const;
  /// x = A^-1 b; both on the matrix's row map.
  void solve(const MultiVector& b, MultiVector& x) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Solves with the tangent: Belos, preconditioned by a factorisation that is kept over several tangents.
class LinearSolver {
 public:
  LinearSolver(RCP<const Matrix> matrix, const LinearOptions& options);
  ~LinearSolver();

  /// The matrix has new values. `fresh`: factorise them now; otherwise the kept factorisation serves until it needs
  /// more than the allowed number of iterations.
  void update(bool fresh);
  /// Returns false if the kept factorisation does not serve any more: update(true) and try again.
  bool solve(const Vector& b, Vector& x);

  bool is_fresh() const;
  bool failed() const;  ///< the last factorisation did
  /// Of the last factorisation; the tangent's own only if it is fresh.
  int negative_pivots() const;
  int iterations() const;      ///< Belos iterations so far
  int factorisations() const;  ///< so far

 private:
  bool iterate(const Vector& b, Vector& x);
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace toile::solve
