#pragma once

#include "linear/factorisation.hpp"
#include "linear/linear_solver.hpp"

namespace toile::solve {

/// What solvers with a sparse factorisation have in common.
class FactorisedSolver : public LinearSolver {
 public:
  explicit FactorisedSolver(RCP<const Matrix> matrix);

  bool take(const RCP<const Matrix>& matrix) override;
  void update(bool fresh) override;
  bool is_fresh() const override { return fresh_; }
  bool failed() const override { return factorisations_ > 0 && !usable_; }
  std::optional<int> negative_pivots() const override { return factorisation_.negative_pivots(); }
  RCP<Vector> softest() override;
  int factorisations() const override { return factorisations_; }

 protected:
  const RCP<const Matrix>& matrix() const { return matrix_; }
  const Factorisation& factorisation() const { return factorisation_; }
  /// By the factorisation alone, as old as it may be.
  bool back_substitute(const Vector& b, Vector& x) const;
  bool usable() const { return usable_; }

 private:
  RCP<const Matrix> matrix_;
  Factorisation factorisation_;
  bool fresh_ = false;
  bool usable_ = false;  ///< a factorisation is there
  int factorisations_ = 0;
};

}  // namespace toile::solve
