#include "path/equilibrium_group.hpp"

#include <LOCA_GlobalData.H>
#include <Thyra_TpetraThyraWrappers.hpp>
#include <utility>

namespace toile::solve {

namespace {

using Extraction = Thyra::TpetraOperatorVectorExtraction<double, LocalId, GlobalId, Node>;

RCP<NOX::Thyra::Vector> wrap(const RCP<Vector>& v) {
  const auto space = Thyra::createVectorSpace<double, LocalId, GlobalId, Node>(v->getMap());
  return rcp(new NOX::Thyra::Vector(Thyra::createVector<double, LocalId, GlobalId, Node>(v, space)));
}

}  // namespace

GlobalData::GlobalData(const RCP<Teuchos::ParameterList>& list) : data_(LOCA::createGlobalData(list)) {}
GlobalData::~GlobalData() {
  LOCA::destroyGlobalData(data_);
}

const Vector& EquilibriumGroup::tpetra(const NOX::Abstract::Vector& v) {
  const auto& wrapped = dynamic_cast<const NOX::Thyra::Vector&>(v);
  return *Extraction::getConstTpetraVector(wrapped.getThyraRCPVector());
}

Vector& EquilibriumGroup::tpetra(NOX::Abstract::Vector& v) {
  auto& wrapped = dynamic_cast<NOX::Thyra::Vector&>(v);
  return *Extraction::getTpetraVector(wrapped.getThyraRCPVector());
}

EquilibriumGroup::EquilibriumGroup(const RCP<LOCA::GlobalData>& global, std::shared_ptr<Equilibrium> equilibrium,
                                   const Vector& start, double s)
    : LOCA::Abstract::Group(global),
      equilibrium_(std::move(equilibrium)),
      x_(wrap(rcp(new Vector(start, Teuchos::Copy)))),
      f_(wrap(rcp(new Vector(start.getMap())))),
      newton_(wrap(rcp(new Vector(start.getMap())))) {
  parameters_.addParameter("s", s);
}

EquilibriumGroup::EquilibriumGroup(const EquilibriumGroup& source, NOX::CopyType type)
    : LOCA::Abstract::Group(source, type),
      equilibrium_(source.equilibrium_),
      parameters_(source.parameters_),
      x_(rcp(new NOX::Thyra::Vector(*source.x_, type))),
      f_(rcp(new NOX::Thyra::Vector(*source.f_, type))),
      newton_(rcp(new NOX::Thyra::Vector(*source.newton_, type))) {
  if (type == NOX::DeepCopy) {
    evaluation_ = source.evaluation_;
    has_f_ = source.has_f_;
    has_newton_ = source.has_newton_;
  }
}

NOX::Abstract::Group& EquilibriumGroup::operator=(const NOX::Abstract::Group& other) {
  const auto& source = dynamic_cast<const EquilibriumGroup&>(other);
  if (this == &source) return *this;
  LOCA::Abstract::Group::copy(source);
  equilibrium_ = source.equilibrium_;
  parameters_ = source.parameters_;
  *x_ = *source.x_;
  *f_ = *source.f_;
  *newton_ = *source.newton_;
  evaluation_ = source.evaluation_;
  has_f_ = source.has_f_;
  has_newton_ = source.has_newton_;
  // The one tangent is shared: it belongs to the group that formed it.
  has_jacobian_ = false;
  return *this;
}

RCP<NOX::Abstract::Group> EquilibriumGroup::clone(NOX::CopyType type) const {
  return rcp(new EquilibriumGroup(*this, type));
}

void EquilibriumGroup::invalidate() {
  has_f_ = has_jacobian_ = has_newton_ = false;
}

void EquilibriumGroup::setX(const NOX::Abstract::Vector& y) {
  invalidate();
  *x_ = y;
}

void EquilibriumGroup::computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) {
  invalidate();
  x_->update(1.0, from.getX(), step, direction);
  equilibrium_->retract(tpetra(*x_), parameter());
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::computeF() {
  if (has_f_) return Ok;
  evaluation_ = equilibrium_->residual(tpetra(*x_), parameter(), tpetra(*f_));
  has_f_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::computeJacobian() {
  if (has_jacobian_) return Ok;
  equilibrium_->linearise(tpetra(*x_), parameter());
  has_jacobian_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::computeDfDpMulti(const std::vector<int>& parameters,
                                                                    NOX::Abstract::MultiVector& f_and_rates,
                                                                    bool has_f) {
  if (!has_f) {
    if (computeF() != Ok) return Failed;
    f_and_rates[0] = *f_;
  }
  for (size_t i = 0; i < parameters.size(); ++i)
    equilibrium_->residual_rate(tpetra(*x_), parameter(), tpetra(f_and_rates[static_cast<int>(i) + 1]));
  return Ok;
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::computeNewton(Teuchos::ParameterList& list) {
  if (has_newton_) return Ok;
  if (computeF() != Ok || computeJacobian() != Ok) return Failed;
  const ReturnType status = applyJacobianInverse(list, *f_, *newton_);
  newton_->scale(-1.0);
  has_newton_ = true;
  return status;
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::applyJacobian(const NOX::Abstract::Vector& in,
                                                                 NOX::Abstract::Vector& out) const {
  if (!has_jacobian_) return BadDependency;
  equilibrium_->apply(tpetra(in), tpetra(out));
  return Ok;
}

NOX::Abstract::Group::ReturnType EquilibriumGroup::applyJacobianInverse(Teuchos::ParameterList&,
                                                                        const NOX::Abstract::Vector& in,
                                                                        NOX::Abstract::Vector& out) const {
  if (!has_jacobian_) return BadDependency;
  if (equilibrium_->solve(tpetra(in), tpetra(out))) return Ok;
  out.init(0.0);
  return NotConverged;  // LOCA would throw at Failed
}

void EquilibriumGroup::setParams(const LOCA::ParameterVector& p) {
  invalidate();
  parameters_ = p;
}

void EquilibriumGroup::setParam(int id, double value) {
  invalidate();
  parameters_.setValue(static_cast<unsigned int>(id), value);
}

void EquilibriumGroup::setParam(std::string id, double value) {
  invalidate();
  parameters_.setValue(id, value);
}

}  // namespace toile::solve
