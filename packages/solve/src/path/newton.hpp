#pragma once

#include <LOCA_GlobalData.H>
#include <NOX_LineSearch_Generic.H>
#include <NOX_StatusTest_Generic.H>
#include <NOX_Utils.H>

#include <ostream>
#include <utility>

#include "path/continuation.hpp"
#include "path/equilibrium_group.hpp"

namespace toile::solve {

/// The equilibrium inside a group of NOX or LOCA (LOCA extends the group and its vectors by the parameter).
const EquilibriumGroup& unwrap(const NOX::Abstract::Group& group);
const NOX::Abstract::Vector& unwrap(const NOX::Abstract::Vector& vector);

/// Converged: relative force residual and contact gap are below their tolerances. Failed: too many iterations, not a
/// number, or refused.
class BalanceTest : public NOX::StatusTest::Generic {
 public:
  explicit BalanceTest(const NewtonOptions& options, AcceptsStep accepts = {})
      : options_(options), accepts_(std::move(accepts)) {}
  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int indent = 0) const override;
  const Evaluation& last() const { return last_; }
  int iterations() const { return iterations_; }

 private:
  bool took_too_many(double residual);

  NewtonOptions options_;
  AcceptsStep accepts_;
  int halved_at_ = 0;      ///< iteration at which the residual was last half of `halved_`
  double halved_ = 1e300;  ///< the residual there
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
  Evaluation last_;
  int iterations_ = 0;
};

/// Backtracking on the potential of the step, with the contact multipliers held at those of the iteration's start
/// (Armijo). A rise below its round-off is none, so that the full step is taken there; whether it was a good one is for
/// the residual of the next iteration to tell.
class EnergyLineSearch : public NOX::LineSearch::Generic {
 public:
  EnergyLineSearch(const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) {}
  bool compute(NOX::Abstract::Group& next, double& step, const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override;
};

/// How far a Newton step goes.
enum class LineSearch {
  energy,  ///< as far as the potential of the step falls
  none     ///< all the way: unstable equilibria are no minima
};

/// NOX parameters of every solve: Newton's method, silent.
RCP<Teuchos::ParameterList> newton_parameters(LineSearch kind);

}  // namespace toile::solve
