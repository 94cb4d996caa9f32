#include "path/newton.hpp"

#include <LOCA_MultiContinuation_ExtendedGroup.H>
#include <LOCA_MultiContinuation_ExtendedVector.H>
#include <NOX_LineSearch_UserDefinedFactoryT.H>
#include <NOX_Solver_Generic.H>
#include <Teuchos_oblackholestream.hpp>

#include <algorithm>
#include <cmath>

#include "watch/watch.hpp"

namespace toile::solve {

const EquilibriumGroup& unwrap(const NOX::Abstract::Group& group) {
  if (const auto* extended = dynamic_cast<const LOCA::MultiContinuation::ExtendedGroup*>(&group))
    return unwrap(*extended->getUnderlyingGroup());
  return dynamic_cast<const EquilibriumGroup&>(group);
}

const NOX::Abstract::Vector& unwrap(const NOX::Abstract::Vector& vector) {
  if (const auto* extended = dynamic_cast<const LOCA::MultiContinuation::ExtendedVector*>(&vector))
    return *extended->getXVec();
  return vector;
}

bool BalanceTest::took_too_many(double residual) {
  constexpr int times = 5;
  if (residual < 0.5 * halved_) {
    halved_ = residual;
    halved_at_ = iterations_;
  }
  const int most = options_.max_iterations, stalled = iterations_ - halved_at_;
  if (!options_.to_rest) return iterations_ >= most;
  return iterations_ >= times * most || (iterations_ >= most && stalled >= most / 3);
}

NOX::StatusTest::StatusType BalanceTest::checkStatus(const NOX::Solver::Generic& solver, NOX::StatusTest::CheckType) {
  const EquilibriumGroup& group = unwrap(solver.getSolutionGroup());
  iterations_ = solver.getNumIterations();
  last_ = group.evaluation();
  const Imbalance& left = last_.imbalance;
  status_ = NOX::StatusTest::Unconverged;
  if (left.relative() <= options_.tolerance && left.gap <= options_.gap_tolerance)
    status_ = !accepts_ || accepts_(EquilibriumGroup::tpetra(group.getX()), group.parameter(), iterations_)
                  ? NOX::StatusTest::Converged
                  : NOX::StatusTest::Failed;
  else if (!std::isfinite(left.force) || !std::isfinite(left.gap) || took_too_many(left.relative()))
    status_ = NOX::StatusTest::Failed;
  Watch* watch = group.equilibrium().watch();
  if (watch != nullptr && !watch->go_on(iterations_, group.parameter(), left.relative(), left.gap) &&
      status_ == NOX::StatusTest::Unconverged)
    status_ = NOX::StatusTest::Failed;
  return status_;
}

std::ostream& BalanceTest::print(std::ostream& stream, int indent) const {
  return stream << std::string(static_cast<size_t>(indent), ' ') << "relative force residual "
                << last_.imbalance.relative() << ", largest gap " << last_.imbalance.gap << " mm\n";
}

bool EnergyLineSearch::compute(NOX::Abstract::Group& next, double& step, const NOX::Abstract::Vector& direction,
                               const NOX::Solver::Generic& solver) {
  constexpr double armijo = 1e-4, round_off = 1e-13, unresolved = 1e-9;
  constexpr int most_halvings = 20;
  const NOX::Abstract::Group& previous = solver.getPreviousSolutionGroup();
  const EquilibriumGroup& old_group = unwrap(previous);
  Equilibrium& equilibrium = old_group.equilibrium();
  const Vector& z = EquilibriumGroup::tpetra(old_group.getX());
  const double s = old_group.parameter();
  // Trial points are retracted onto the body; so is the point that they are compared with.
  Vector start(z, Teuchos::Copy);
  const double old_energy = equilibrium.retract(start, s) ? equilibrium.energy(start, z, s)
                                                          : equilibrium.energy(old_group.evaluation(), z, z, s);
  const double scale = std::max(std::abs(old_energy), std::abs(old_group.evaluation().strain_energy));
  const auto slope_at = [&](const EquilibriumGroup& at) {
    return equilibrium.slope_along_surface(EquilibriumGroup::tpetra(at.getF()),
                                           EquilibriumGroup::tpetra(unwrap(direction)));
  };
  const double slope = slope_at(old_group);
  step = 0.0;
  if (direction.norm() == 0.0) {  // the linear system had no solution
    next.computeX(previous, direction, step);
    next.computeF();
    return false;
  }
  step = 1.0;
  for (int i = 0; i <= most_halvings; ++i, step *= 0.5) {
    next.computeX(previous, direction, step);
    if (next.computeF() != NOX::Abstract::Group::Ok) continue;
    const EquilibriumGroup& new_group = unwrap(next);
    const double new_energy = equilibrium.energy(new_group.evaluation(), EquilibriumGroup::tpetra(new_group.getX()), z,
                                                 new_group.parameter());
    if (!std::isfinite(new_energy) || !std::isfinite(new_group.getNormF())) continue;
    if (new_energy <= old_energy + armijo * step * std::min(slope, 0.0) + round_off * scale) return true;
    // A stiff fabric's energy is known to round-off of its stress, not of itself: near the solution the decrease drowns
    // in it, and a full Newton step would be refused by chance. The slope at the new point, a product of forces, is
    // exact there: Armijo's condition on the parabola through both slopes (Hager and Zhang, SIAM J. Optim. 16 (2005),
    // 170-192, equation 4.1).
    if (std::abs(slope) <= unresolved * scale && new_energy <= old_energy + unresolved * scale &&
        slope_at(new_group) <= (2.0 * armijo - 1.0) * slope)
      return true;
  }
  step = 0.0;
  return false;
}

namespace {

// What a failed attempt has to say is said by the stage.
void set_silent(Teuchos::ParameterList& list) {
  Teuchos::ParameterList& printing = list.sublist("Printing");
  printing.set("Output Information", 0);
  for (const char* stream : {"Output Stream", "Error Stream"})
    printing.set<RCP<std::ostream>>(stream, rcp(new Teuchos::oblackholestream));
}

}  // namespace

RCP<Teuchos::ParameterList> newton_parameters(LineSearch kind) {
  RCP<Teuchos::ParameterList> list = Teuchos::parameterList();
  list->set("Nonlinear Solver", "Line Search Based");
  list->sublist("Direction").set("Method", "Newton");
  // Without a solution of the linear system the direction is zero, and the line search fails the step; otherwise NOX
  // would throw (and LOCA, if the group called it failed).
  list->sublist("Direction").sublist("Newton").set("Rescue Bad Newton Solve", true);
  Teuchos::ParameterList& search = list->sublist("Line Search");
  if (kind == LineSearch::none) {
    search.set("Method", "Full Step");
    set_silent(*list);
    return list;
  }
  search.set("Method", "User Defined");
  const RCP<NOX::LineSearch::UserDefinedFactory> factory =
      rcp(new NOX::LineSearch::UserDefinedFactoryT<EnergyLineSearch>);
  search.set("User Defined Line Search Factory", factory);
  set_silent(*list);
  return list;
}

}  // namespace toile::solve
