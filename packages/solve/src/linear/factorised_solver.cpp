#include "linear/factorised_solver.hpp"

#include <cmath>

#include "linear/inverse_iterations.hpp"

namespace toile::solve {

FactorisedSolver::FactorisedSolver(RCP<const Matrix> matrix) : matrix_(std::move(matrix)), factorisation_(*matrix_) {}

bool FactorisedSolver::take(const RCP<const Matrix>& matrix) {
  if (!factorisation_.fits(*matrix)) return false;
  matrix_ = matrix;
  fresh_ = usable_ = false;
  factorisations_ = 0;
  return true;
}

void FactorisedSolver::update(bool fresh) {
  fresh_ = false;
  if (!fresh && usable_) return;
  usable_ = factorisation_.factorise(*matrix_);
  fresh_ = usable_;
  ++factorisations_;
}

RCP<Vector> FactorisedSolver::softest() {
  return inverse_iterations(matrix_->getRowMap(), [this](const Vector& b, Vector& x) { return back_substitute(b, x); });
}

bool FactorisedSolver::back_substitute(const Vector& b, Vector& x) const {
  if (!usable_) return false;
  factorisation_.solve(b, x);
  return std::isfinite(x.norm2());
}

}  // namespace toile::solve
