// What Newton does where there is no direction to go.
#include "path/newton.hpp"

#include <gtest/gtest.h>

#include <NOX_Solver_Generic.H>
#include <NOX_SolverStats.hpp>

#include "stages.hpp"

namespace toile::test {
namespace {

using solve::EquilibriumGroup;
using Teuchos::RCP;
using Teuchos::rcp;

/// A solver that stands at one group.
class Standing : public NOX::Solver::Generic {
 public:
  explicit Standing(RCP<const NOX::Abstract::Group> group) : group_(std::move(group)) {}
  void reset() override {}
  void reset(const NOX::Abstract::Vector&) override {}
  void reset(const NOX::Abstract::Vector&, const RCP<NOX::StatusTest::Generic>&) override {}
  NOX::StatusTest::StatusType step() override { return NOX::StatusTest::Unconverged; }
  NOX::StatusTest::StatusType solve() override { return NOX::StatusTest::Unconverged; }
  const NOX::Abstract::Group& getSolutionGroup() const override { return *group_; }
  const NOX::Abstract::Group& getPreviousSolutionGroup() const override { return *group_; }
  NOX::StatusTest::StatusType getStatus() const override { return NOX::StatusTest::Unconverged; }
  int getNumIterations() const override { return 0; }
  const Teuchos::ParameterList& getList() const override { return list_; }
  RCP<const NOX::Abstract::Group> getSolutionGroupPtr() const override { return group_; }
  RCP<const NOX::Abstract::Group> getPreviousSolutionGroupPtr() const override { return group_; }
  RCP<const Teuchos::ParameterList> getListPtr() const override { return Teuchos::rcpFromRef(list_); }
  RCP<const NOX::SolverStats> getSolverStatistics() const override { return Teuchos::null; }

 private:
  RCP<const NOX::Abstract::Group> group_;
  Teuchos::ParameterList list_;
};

// Without a solution of the linear system the direction is zero: the line search fails, and the iteration stays where
// it is, with a residual that can be judged.
TEST(EnergyLineSearch, FailsWithoutADirection) {
  Sleeve sleeve(options(12, 6), neo_hookean());
  solve::Held held;
  held.position.resize(sleeve.problem.clusters.size());
  const auto equilibrium = std::make_shared<solve::Equilibrium>(sleeve.problem, closed_start(sleeve.problem), held,
                                                                solve::Drive{1.0, 1.0, 0.0, 0.0},
                                                                solve::SolverOptions(), Tpetra::getDefaultComm());
  const RCP<Teuchos::ParameterList> list = solve::newton_parameters(solve::LineSearch::energy);
  const RCP<LOCA::GlobalData> global = LOCA::createGlobalData(list);
  const RCP<EquilibriumGroup> group = rcp(new EquilibriumGroup(global, equilibrium, *equilibrium->start_vector(), 0.0));
  group->computeF();
  equilibrium->linearise(*equilibrium->start_vector(), 0.0);
  const RCP<NOX::Abstract::Vector> direction = group->getX().clone(NOX::ShapeCopy);
  direction->init(0.0);
  const RCP<NOX::Abstract::Group> next = group->clone(NOX::ShapeCopy);
  double step = 1.0;
  solve::EnergyLineSearch search(Teuchos::null, *list);
  EXPECT_FALSE(search.compute(*next, step, *direction, Standing(group)));
  EXPECT_EQ(step, 0.0);
  EXPECT_TRUE(next->isF());
  EXPECT_GT(next->getNormF(), 0.0);
  LOCA::destroyGlobalData(global);
}

}  // namespace
}  // namespace toile::test
