#include <BelosBlockGmresSolMgr.hpp>
#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>

#include "linear/factorised_solver.hpp"

namespace toile::solve {
namespace {

/// The kept factorisation as a preconditioner.
class FactorisedOperator : public Operator {
 public:
  FactorisedOperator(RCP<const Map> map, const Factorisation& factorisation)
      : map_(std::move(map)), factorisation_(factorisation) {}
  RCP<const Map> getDomainMap() const override { return map_; }
  RCP<const Map> getRangeMap() const override { return map_; }
  void apply(const MultiVector& b, MultiVector& x, Teuchos::ETransp, double alpha, double beta) const override {
    if (beta == 0.0 && alpha == 1.0) {
      factorisation_.solve(b, x);
      return;
    }
    MultiVector solution(x.getMap(), x.getNumVectors());
    factorisation_.solve(b, solution);
    x.update(alpha, solution, beta);
  }

 private:
  RCP<const Map> map_;
  const Factorisation& factorisation_;
};

using LinearProblem = Belos::LinearProblem<double, MultiVector, Operator>;
using Manager = Belos::SolverManager<double, MultiVector, Operator>;

/// Belos, preconditioned by a factorisation that is kept over several tangents, until it needs more than the allowed
/// number of iterations.
class KrylovSolver : public FactorisedSolver {
 public:
  /// `gmres`: preconditioned on the right, for matrices that are not definite; otherwise conjugate gradients.
  KrylovSolver(const RCP<const Matrix>& matrix, const LinearOptions& options, bool gmres)
      : FactorisedSolver(matrix),
        preconditioner_(rcp(new FactorisedOperator(matrix->getRowMap(), factorisation()))),
        gmres_(gmres) {
    const RCP<Teuchos::ParameterList> list = Teuchos::parameterList();
    list->set("Maximum Iterations", options.kept_iterations);
    list->set("Convergence Tolerance", options.tolerance);
    list->set("Verbosity", static_cast<int>(Belos::Errors));
    if (gmres) {
      list->set("Num Blocks", options.kept_iterations);
      list->set("Maximum Restarts", 0);
      manager_ = rcp(new Belos::BlockGmresSolMgr<double, MultiVector, Operator>());
    } else {
      list->set("Assert Positive Definiteness", false);  // negative pivots are dealt with by the caller
      manager_ = rcp(new Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator>());
    }
    manager_->setParameters(list);
  }

  bool take(const RCP<const Matrix>& matrix) override {
    iterations_ = 0;
    return FactorisedSolver::take(matrix);
  }

  bool solve(const Vector& b, Vector& x) override {
    if (b.norm2() == 0.0) {
      x.putScalar(0.0);
      return true;
    }
    if (iterate(b, x)) return true;
    // The tolerance was missed with the tangent's own factors (badly conditioned): the direct solution is still a
    // direction, and the nonlinear residual decides about the step.
    return is_fresh() && back_substitute(b, x);
  }

  int iterations() const override { return iterations_; }

 private:
  bool iterate(const Vector& b, Vector& x) {
    if (!usable()) return false;
    x.putScalar(0.0);
    const RCP<LinearProblem> problem = rcp(
        new LinearProblem(matrix(), Teuchos::rcpFromRef<MultiVector>(x), Teuchos::rcpFromRef<const MultiVector>(b)));
    if (gmres_)
      problem->setRightPrec(preconditioner_);
    else
      problem->setLeftPrec(preconditioner_);
    if (!problem->setProblem()) return false;
    manager_->setProblem(problem);
    bool converged = false;
    try {
      converged = manager_->solve() == Belos::Converged;
    } catch (const Belos::StatusTestError&) {
      converged = false;  // not a number in the recurrence: the caller renews the factorisation
    }
    iterations_ += manager_->getNumIters();
    return converged && std::isfinite(x.norm2());
  }

  RCP<Operator> preconditioner_;
  RCP<Manager> manager_;
  bool gmres_;
  int iterations_ = 0;
};

}  // namespace

LinearSolverKind cg_solver() {
  return {"cg", "conjugate gradients (Belos), preconditioned by a sparse factorisation that is kept",
          [](const RCP<const Matrix>& matrix, const LinearOptions& options) -> std::unique_ptr<LinearSolver> {
            return std::make_unique<KrylovSolver>(matrix, options, false);
          }};
}

LinearSolverKind gmres_solver() {
  return {"gmres", "the same by GMRES, for tangents that are not definite",
          [](const RCP<const Matrix>& matrix, const LinearOptions& options) -> std::unique_ptr<LinearSolver> {
            return std::make_unique<KrylovSolver>(matrix, options, true);
          }};
}

}  // namespace toile::solve
