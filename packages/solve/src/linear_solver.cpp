#include "linear_solver.hpp"

#include <BelosBlockGmresSolMgr.hpp>
#include <BelosLinearProblem.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>

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

}  // namespace

struct LinearSolver::Data {
  RCP<const Matrix> matrix;
  LinearOptions options;
  Factorisation factorisation;
  RCP<Operator> preconditioner;
  RCP<Manager> manager;
  bool fresh = false;
  bool usable = false;  ///< a factorisation is there
  int iterations = 0;
  int factorisations = 0;

  Data(RCP<const Matrix> a, LinearOptions o) : matrix(std::move(a)), options(std::move(o)), factorisation(*matrix) {
    preconditioner = rcp(new FactorisedOperator(matrix->getRowMap(), factorisation));
    RCP<Teuchos::ParameterList> list = Teuchos::parameterList();
    list->set("Maximum Iterations", options.kept_iterations);
    list->set("Convergence Tolerance", options.tolerance);
    list->set("Verbosity", static_cast<int>(Belos::Errors));
    if (options.method == "gmres") {
      list->set("Num Blocks", options.kept_iterations);
      list->set("Maximum Restarts", 0);
      manager = rcp(new Belos::BlockGmresSolMgr<double, MultiVector, Operator>());
    } else if (options.method == "cg") {
      list->set("Assert Positive Definiteness", false);  // negative pivots are dealt with by the caller
      manager = rcp(new Belos::PseudoBlockCGSolMgr<double, MultiVector, Operator>());
    }
    if (!manager.is_null()) manager->setParameters(list);
  }
};

LinearSolver::LinearSolver(RCP<const Matrix> matrix, const LinearOptions& options)
    : data_(std::make_unique<Data>(std::move(matrix), options)) {}
LinearSolver::~LinearSolver() = default;

void LinearSolver::update(bool fresh) {
  Data& d = *data_;
  d.fresh = false;
  if (!fresh && d.usable && d.options.method != "direct") return;
  d.usable = d.factorisation.factorise(*d.matrix);
  d.fresh = d.usable;
  ++d.factorisations;
}

bool LinearSolver::iterate(const Vector& b, Vector& x) {
  Data& d = *data_;
  if (!d.usable) return false;
  if (d.manager.is_null()) {
    d.factorisation.solve(b, x);
    return std::isfinite(x.norm2());
  }
  x.putScalar(0.0);
  const RCP<LinearProblem> problem =
      rcp(new LinearProblem(d.matrix, Teuchos::rcpFromRef<MultiVector>(x), Teuchos::rcpFromRef<const MultiVector>(b)));
  if (d.manager.is_null() || d.options.method == "gmres")
    problem->setRightPrec(d.preconditioner);
  else
    problem->setLeftPrec(d.preconditioner);
  if (!problem->setProblem()) return false;
  d.manager->setProblem(problem);
  bool converged = false;
  try {
    converged = d.manager->solve() == Belos::Converged;
  } catch (const Belos::StatusTestError&) {
    converged = false;  // not a number in the recurrence: the caller renews the factorisation
  }
  d.iterations += d.manager->getNumIters();
  return converged && std::isfinite(x.norm2());
}

bool LinearSolver::solve(const Vector& b, Vector& x) {
  Data& d = *data_;
  if (b.norm2() == 0.0) {
    x.putScalar(0.0);
    return true;
  }
  if (iterate(b, x)) return true;
  if (!d.fresh || !d.usable) return false;
  // The tolerance was missed with the tangent's own factors (badly conditioned): the direct solution is still a
  // direction, and the nonlinear residual decides about the step.
  d.factorisation.solve(b, x);
  return std::isfinite(x.norm2());
}

bool LinearSolver::is_fresh() const {
  return data_->fresh;
}
bool LinearSolver::failed() const {
  return data_->factorisations > 0 && !data_->usable;
}
int LinearSolver::negative_pivots() const {
  return data_->factorisation.negative_pivots();
}
int LinearSolver::iterations() const {
  return data_->iterations;
}
int LinearSolver::factorisations() const {
  return data_->factorisations;
}

}  // namespace toile::solve
