#include "continuation.hpp"

#include <LOCA_GlobalData.H>
#include <LOCA_Parameter_SublistParser.H>
#include <LOCA_Stepper.H>
#include <NOX_Solver_Factory.H>

#include "equilibrium_group.hpp"
#include "newton.hpp"

namespace toile::solve {

namespace {

/// Leaves LOCA's loop.
struct PathEnd {};

RCP<Vector> copy(const Vector& z) {
  return rcp(new Vector(z, Teuchos::Copy));
}

LineSearch line_search(const StageOptions& stage) {
  return stage.arc_length ? LineSearch::none : LineSearch::energy;
}

void set_stepper(Teuchos::ParameterList& loca, const StageOptions& stage, int most_iterations, bool tangent_first) {
  Teuchos::ParameterList& stepper = loca.sublist("Stepper");
  stepper.set("Continuation Method", stage.arc_length ? "Arc Length" : "Natural");
  stepper.set("Continuation Parameter", "s");
  stepper.set("Initial Value", 0.0);
  stepper.set("Min Value", -1e3);  // never met: between limit points the load may change its sign
  stepper.set("Max Value", stage.until ? 1e3 : 1.0);
  stepper.set("Max Steps", stage.max_steps);
  stepper.set("Max Nonlinear Iterations", most_iterations);
  stepper.set("Compute Eigenvalues", false);
  Teuchos::ParameterList& size = loca.sublist("Step Size");
  size.set("Method", "Adaptive");
  size.set("Initial Step Size", stage.first_step);
  size.set("Min Step Size", stage.smallest_step);
  size.set("Max Step Size", stage.largest_step);
  size.set("Aggressiveness", 1.0);
  loca.sublist("Predictor").set("Method", "Secant");
  loca.sublist("Predictor").sublist("First Step Predictor").set("Method", tangent_first ? "Tangent" : "Constant");
}

}  // namespace

Attempt solve_at(const std::shared_ptr<Equilibrium>& equilibrium, const StageOptions& stage,
                 const NewtonOptions& options, const Vector& z, double s) {
  const RCP<Teuchos::ParameterList> top = Teuchos::parameterList();
  top->sublist("NOX") = *newton_parameters(line_search(stage));
  const RCP<LOCA::GlobalData> global = LOCA::createGlobalData(top);
  const RCP<EquilibriumGroup> group =
      rcp(new EquilibriumGroup(global, equilibrium, z, s, std::make_shared<StepHooks>()));
  const RCP<BalanceTest> test = rcp(new BalanceTest(options));
  group->computeF();
  const auto solver = NOX::Solver::buildSolver(group, test, Teuchos::sublist(top, "NOX"));
  const bool converged = solver->solve() == NOX::StatusTest::Converged;
  const RCP<Vector> end = copy(EquilibriumGroup::tpetra(unwrap(solver->getSolutionGroup()).getX()));
  LOCA::destroyGlobalData(global);
  return {end, s, converged, test->iterations(), test->last()};
}

void follow_path(const std::shared_ptr<Equilibrium>& equilibrium, const StageOptions& stage,
                 const NewtonOptions& options, bool tangent_first, const Vector& z, const PathHooks& path) {
  const RCP<Teuchos::ParameterList> top = Teuchos::parameterList();
  top->sublist("NOX") = *newton_parameters(line_search(stage));
  set_stepper(top->sublist("LOCA"), stage, options.max_iterations, tangent_first);
  const RCP<LOCA::GlobalData> global = LOCA::createGlobalData(top);
  const RCP<BalanceTest> test = rcp(new BalanceTest(options, path.accepts));
  const auto hooks = std::make_shared<StepHooks>();
  hooks->after = [&](const Vector& at, double s, bool converged) {
    if (!path.report({copy(at), s, converged, test->iterations(), test->last()})) throw PathEnd();
  };
  const RCP<EquilibriumGroup> group = rcp(new EquilibriumGroup(global, equilibrium, z, 0.0, hooks));
  LOCA::Stepper run(global, group, test, top);
  try {
    run.run();
  } catch (const PathEnd&) {  // on every rank: what ends a path is the same on all
  }
  LOCA::destroyGlobalData(global);
}

}  // namespace toile::solve
