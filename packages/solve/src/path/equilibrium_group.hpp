#pragma once

#include <LOCA_Abstract_Group.H>
#include <LOCA_Parameter_Vector.H>
#include <NOX_Thyra_Vector.H>

#include <memory>

#include "equilibrium/equilibrium.hpp"

namespace toile::solve {

/// What every group of LOCA needs, and what must be destroyed after it.
class GlobalData {
 public:
  explicit GlobalData(const RCP<Teuchos::ParameterList>& list);
  GlobalData(const GlobalData&) = delete;
  GlobalData& operator=(const GlobalData&) = delete;
  ~GlobalData();
  const RCP<LOCA::GlobalData>& get() const { return data_; }

 private:
  RCP<LOCA::GlobalData> data_;
};

/// The equilibrium as NOX and LOCA see it: a residual, a tangent with its solve, and one parameter s.
class EquilibriumGroup : public LOCA::Abstract::Group {
 public:
  EquilibriumGroup(const RCP<LOCA::GlobalData>& global, std::shared_ptr<Equilibrium> equilibrium, const Vector& start,
                   double s);
  EquilibriumGroup(const EquilibriumGroup& source, NOX::CopyType type);

  Equilibrium& equilibrium() const { return *equilibrium_; }
  double parameter() const { return parameters_.getValue(0); }
  const Evaluation& evaluation() const { return evaluation_; }  ///< of F
  static const Vector& tpetra(const NOX::Abstract::Vector& v);
  static Vector& tpetra(NOX::Abstract::Vector& v);

  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override;
  RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override;
  void setX(const NOX::Abstract::Vector& y) override;
  void computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) override;
  ReturnType computeF() override;
  ReturnType computeJacobian() override;
  ReturnType computeNewton(Teuchos::ParameterList& list) override;
  /// LOCA's own differences are 1e-6 of the parameter: at the start of a stage, where it is zero, only round-off.
  ReturnType computeDfDpMulti(const std::vector<int>& parameters, NOX::Abstract::MultiVector& f_and_rates,
                              bool has_f) override;
  ReturnType applyJacobian(const NOX::Abstract::Vector& in, NOX::Abstract::Vector& out) const override;
  ReturnType applyJacobianInverse(Teuchos::ParameterList& list, const NOX::Abstract::Vector& in,
                                  NOX::Abstract::Vector& out) const override;
  bool isF() const override { return has_f_; }
  bool isJacobian() const override { return has_jacobian_; }
  bool isNewton() const override { return has_newton_; }
  const NOX::Abstract::Vector& getX() const override { return *x_; }
  const NOX::Abstract::Vector& getF() const override { return *f_; }
  double getNormF() const override { return f_->norm(); }
  const NOX::Abstract::Vector& getGradient() const override { return *f_; }
  const NOX::Abstract::Vector& getNewton() const override { return *newton_; }
  RCP<const NOX::Abstract::Vector> getXPtr() const override { return x_; }
  RCP<const NOX::Abstract::Vector> getFPtr() const override { return f_; }
  RCP<const NOX::Abstract::Vector> getGradientPtr() const override { return f_; }
  RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return newton_; }

  void copy(const NOX::Abstract::Group& source) override { *this = source; }
  void setParams(const LOCA::ParameterVector& p) override;
  void setParam(int id, double value) override;
  void setParam(std::string id, double value) override;
  const LOCA::ParameterVector& getParams() const override { return parameters_; }
  double getParam(int id) const override { return parameters_.getValue(id); }
  double getParam(std::string id) const override { return parameters_.getValue(id); }
  void projectToDraw(const NOX::Abstract::Vector&, double*) const override {}
  int projectToDrawDimension() const override { return 0; }
  void printSolution(const double) const override {}

 private:
  void invalidate();

  std::shared_ptr<Equilibrium> equilibrium_;
  LOCA::ParameterVector parameters_;
  RCP<NOX::Thyra::Vector> x_, f_, newton_;
  Evaluation evaluation_;
  bool has_f_ = false, has_jacobian_ = false, has_newton_ = false;
};

}  // namespace toile::solve
