#include <Amesos2.hpp>

#include <exception>

#include "linear/inverse_iterations.hpp"
#include "linear/linear_solver.hpp"

namespace toile::solve {
namespace {

/// LU of every tangent, gathered on one rank. It knows nothing of the inertia.
class Klu2Solver : public LinearSolver {
 public:
  explicit Klu2Solver(const RCP<const Matrix>& matrix)
      : map_(matrix->getRowMap()), solver_(Amesos2::create<Matrix, MultiVector>("KLU2", matrix)) {
    solver_->symbolicFactorization();
  }

  bool take(const RCP<const Matrix>&) override { return false; }
  void update(bool) override {
    ++factorisations_;
    try {
      solver_->numericFactorization();
      usable_ = true;
    } catch (const std::exception&) {  // a zero pivot
      usable_ = false;
    }
  }
  bool solve(const Vector& b, Vector& x) override {
    if (!usable_) return false;
    solver_->setX(rcp(&x, false));
    solver_->setB(rcp(&b, false));
    solver_->solve();
    return true;
  }
  bool is_fresh() const override { return usable_; }
  bool failed() const override { return factorisations_ > 0 && !usable_; }
  RCP<Vector> softest() override {
    return inverse_iterations(map_, [this](const Vector& b, Vector& x) { return solve(b, x); });
  }
  int factorisations() const override { return factorisations_; }

 private:
  RCP<const Map> map_;
  RCP<Amesos2::Solver<Matrix, MultiVector>> solver_;
  int factorisations_ = 0;
  bool usable_ = false;
};

}  // namespace

LinearSolverKind klu2_solver() {
  return {"klu2", "LU of every tangent (KLU2), which does not tell whether a state is stable; to compare with",
          [](const RCP<const Matrix>& matrix, const LinearOptions&) -> std::unique_ptr<LinearSolver> {
            return std::make_unique<Klu2Solver>(matrix);
          }};
}

}  // namespace toile::solve
