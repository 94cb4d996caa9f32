#include "path/arc_path.hpp"

#include <LOCA_GlobalData.H>
#include <LOCA_MultiContinuation_ArcLengthGroup.H>
#include <LOCA_MultiContinuation_ExtendedMultiVector.H>
#include <LOCA_MultiContinuation_ExtendedVector.H>
#include <LOCA_MultiPredictor_AbstractStrategy.H>
#include <LOCA_Parameter_SublistParser.H>
#include <NOX_Solver_Factory.H>
#include <NOX_Solver_Generic.H>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "path/newton.hpp"

namespace toile::solve {

namespace {

using LOCA::MultiContinuation::ExtendedMultiVector;
using LOCA::MultiContinuation::ExtendedVector;

/// LOCA's predictor: the direction that it is given.
class GivenDirection : public LOCA::MultiPredictor::AbstractStrategy {
 public:
  GivenDirection(RCP<const Vector> direction, double ds) : direction_(std::move(direction)), ds_(ds) {}

  LOCA::MultiPredictor::AbstractStrategy& operator=(const LOCA::MultiPredictor::AbstractStrategy& source) override {
    const auto& given = dynamic_cast<const GivenDirection&>(source);
    direction_ = given.direction_;
    ds_ = given.ds_;
    return *this;
  }
  GivenDirection& operator=(const GivenDirection&) = delete;
  GivenDirection(const GivenDirection&) = default;
  RCP<LOCA::MultiPredictor::AbstractStrategy> clone(NOX::CopyType) const override {
    return rcp(new GivenDirection(*this));
  }
  NOX::Abstract::Group::ReturnType compute(bool, const std::vector<double>&, LOCA::MultiContinuation::ExtendedGroup&,
                                           const ExtendedVector&, const ExtendedVector&) override {
    return NOX::Abstract::Group::Ok;
  }
  NOX::Abstract::Group::ReturnType evaluate(const std::vector<double>& length, const ExtendedVector& from,
                                            ExtendedMultiVector& to) const override {
    set(to);
    to[0].update(1.0, from, length[0]);
    return NOX::Abstract::Group::Ok;
  }
  NOX::Abstract::Group::ReturnType computeTangent(ExtendedMultiVector& tangent) override {
    set(tangent);
    return NOX::Abstract::Group::Ok;
  }
  bool isTangentScalable() const override { return true; }

 private:
  void set(ExtendedMultiVector& tangent) const {
    auto& column = dynamic_cast<ExtendedVector&>(tangent[0]);
    Tpetra::deep_copy(EquilibriumGroup::tpetra(*column.getXVec()), *direction_);
    column.setScalar(0, ds_);
  }

  RCP<const Vector> direction_;
  double ds_;
};

}  // namespace

double ArcPath::rate(const Vector& direction) const {
  return 1.0 / std::sqrt(direction.dot(direction) + memory_.weight * memory_.weight);
}

// Where s takes most of the arc's length, a step could not follow the garment: its weight is lowered.
void ArcPath::find_weight(const Vector& direction) {
  constexpr double most = 0.8, wanted = 0.5, least = 1e-3;  // of the arc's length; least weight
  const double r = rate(direction), share = r * memory_.weight;
  if (share <= most) return;
  const double weight = wanted / r * std::sqrt(std::abs(1.0 - share * share) / (1.0 - wanted * wanted));
  memory_.weight = std::max(weight, least);
}

double ArcPath::rescale(const Vector& direction) {
  const double before = rate(direction);
  find_weight(direction);
  return before / rate(direction);
}

Attempt ArcPath::step(const Vector& z, double s) {
  const RCP<const Vector> along = direction(z, s);
  if (memory_.attempts++ == 0) {  // lengths are of s so far
    find_weight(*along);
    for (double* length : {&memory_.step, &memory_.smallest, &memory_.largest}) *length /= rate(*along);
  }
  aim(s, sign() * rate(*along));
  const RCP<Teuchos::ParameterList> top = Teuchos::parameterList();
  top->sublist("NOX") = *newton_parameters(LineSearch::none);
  Teuchos::ParameterList& stepper = top->sublist("LOCA").sublist("Stepper");
  stepper.set("Initial Scale Factor", memory_.weight);
  stepper.set("Max Arc Length Parameter Contribution", 1e30);  // the weight is ours
  const GlobalData global(top);
  const RCP<LOCA::Parameter::SublistParser> lists = rcp(new LOCA::Parameter::SublistParser(global.get()));
  lists->parseSublists(top);
  const RCP<EquilibriumGroup> group = rcp(new EquilibriumGroup(global.get(), equilibrium_, z, s));
  const RCP<LOCA::MultiContinuation::ArcLengthGroup> arc =
      rcp(new LOCA::MultiContinuation::ArcLengthGroup(global.get(), lists, lists->getSublist("Stepper"), group,
                                                      rcp(new GivenDirection(along, sign())), std::vector<int>{0}));
  arc->setPrevX(arc->getX());
  arc->computePredictor();
  arc->setStepSize(memory_.step);
  arc->computeX(*arc, arc->getPredictorTangent()[0], memory_.step);
  const RCP<BalanceTest> test = rcp(new BalanceTest(options_, accepts()));
  arc->computeF();
  const auto solver = NOX::Solver::buildSolver(arc, test, Teuchos::sublist(top, "NOX"));
  const bool converged = solver->solve() == NOX::StatusTest::Converged;
  const EquilibriumGroup& end = unwrap(solver->getSolutionGroup());
  return {rcp(new Vector(EquilibriumGroup::tpetra(end.getX()), Teuchos::Copy)), end.parameter(), converged,
          test->iterations(), test->last()};
}

}  // namespace toile::solve
