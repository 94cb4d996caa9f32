#include "linear/factorised_solver.hpp"

namespace toile::solve {
namespace {

/// Factorises every tangent.
class DirectSolver : public FactorisedSolver {
 public:
  explicit DirectSolver(const RCP<const Matrix>& matrix) : FactorisedSolver(matrix) {}

  void update(bool /*fresh*/) override { FactorisedSolver::update(true); }
  bool solve(const Vector& b, Vector& x) override { return back_substitute(b, x); }
};

}  // namespace

LinearSolverKind direct_solver() {
  return {"direct", "factorisation of every tangent (MUMPS)",
          [](const RCP<const Matrix>& matrix, const LinearOptions&) -> std::unique_ptr<LinearSolver> {
            return std::make_unique<DirectSolver>(matrix);
          }};
}

}  // namespace toile::solve
