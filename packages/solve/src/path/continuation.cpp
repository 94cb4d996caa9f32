#include "path/continuation.hpp"

#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>

#include "path/newton.hpp"

namespace toile::solve {

Attempt solve_at(const std::shared_ptr<Equilibrium>& equilibrium, const StageOptions& stage,
                 const NewtonOptions& options, const Vector& z, double s, const AcceptsStep& accepts) {
  const RCP<Teuchos::ParameterList> top = Teuchos::parameterList();
  top->sublist("NOX") = *newton_parameters(stage.arc_length ? LineSearch::none : LineSearch::energy);
  const GlobalData global(top);
  const RCP<EquilibriumGroup> group = rcp(new EquilibriumGroup(global.get(), equilibrium, z, s));
  const RCP<BalanceTest> test = rcp(new BalanceTest(options, accepts));
  group->computeF();
  const auto solver = NOX::Solver::buildSolver(group, test, Teuchos::sublist(top, "NOX"));
  const bool converged = solver->solve() == NOX::StatusTest::Converged;
  const Vector& end = EquilibriumGroup::tpetra(unwrap(solver->getSolutionGroup()).getX());
  return {rcp(new Vector(end, Teuchos::Copy)), s, converged, test->iterations(), test->last()};
}

}  // namespace toile::solve
