// Residual, tangent and potential of one stage belong together.
#include "equilibrium/equilibrium.hpp"

#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "panels.hpp"
#include "sleeve.hpp"

namespace toile::test {
namespace {

using solve::Drive;
using solve::Equilibrium;
using solve::Held;
using solve::Vector;

/// A sleeve that is pushed onto a cylinder a little larger than its placed radius, half sewn, damped and loaded: every
/// term of the equilibrium is at work.
struct Fixture {
  Sleeve sleeve;
  std::unique_ptr<Equilibrium> equilibrium;
  Teuchos::RCP<Vector> z;
  const double s = 0.4;

  static Sleeve::Options options(const char* formulation) {
    Sleeve::Options o;
    o.formulation = formulation;
    o.around = 12;
    o.along = 6;
    o.ranks = Tpetra::getDefaultComm()->getSize();
    return o;
  }

  explicit Fixture(const char* formulation = "membrane4")
      : sleeve(options(formulation), std::make_shared<material::Material>(*material::find("neo-hookean"),
                                                                          std::vector<double>{8.4667e-3}, 1.0)) {
    constexpr int along = 6;
    for (int j = 0; j <= along; ++j)  // open the seam by turning its second side away
      sleeve.mesh.placed[static_cast<size_t>(j) * 13 + 12] += solve::Vec3(0.5, -4.0, 0.3);
    sleeve.problem.loads.push_back(pull(sleeve.problem.supports[1].nodes, solve::Vec3(3e-3, 5e-3, 0.0)));
    Held held;
    held.position.resize(sleeve.problem.clusters.size());
    for (int i = 0; i < 12; ++i) held.position[i][2] = {true, 0.0, 1.5, 0};
    const solve::State start = placed_state(sleeve.problem);
    if (!start.frame.empty()) {
      held.rotation.assign(static_cast<size_t>(sleeve.mesh.nodes()), {false, false});
      for (int i = 0; i <= 12; ++i) held.rotation[static_cast<size_t>(i)] = {false, true};
      solve::NodalLoad moment = pull(sleeve.problem.supports[1].nodes, solve::Vec3(0.02, 0.01, 0.03));
      moment.moment = true;
      sleeve.problem.loads.push_back(moment);
    }
    equilibrium = std::make_unique<Equilibrium>(sleeve.problem, start, held, Drive{0.0, 1.0, 0.0, 1.0},
                                                solve::SolverOptions(), Tpetra::getDefaultComm());
    equilibrium->set_damping(1e-3);
    equilibrium->start_step(*equilibrium->start_vector(), 0.0);
    z = equilibrium->start_vector();
    shake(*z, 0.3, 1);
  }

  /// Adds noise that depends on the component only, so that it is the same for any number of ranks.
  static void shake(Vector& v, double size, int seed) {
    auto data = v.getDataNonConst();
    for (int i = 0; i < static_cast<int>(data.size()); ++i) {
      const double id = static_cast<double>(v.getMap()->getGlobalElement(i));
      data[i] += size * std::sin(12.9898 * (id + 1.0) * seed + 0.37 * seed);
    }
  }
};

class EquilibriumOf : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formulations, EquilibriumOf, testing::Values("membrane4", "shell4", "shell4r"));

// The residual of the forces is the gradient of the potential with the contact multipliers held.
TEST_P(EquilibriumOf, ResidualIsTheGradientOfThePotential) {
  Fixture f(GetParam());
  Vector residual(f.z->getMap()), direction(f.z->getMap());
  Fixture::shake(direction, 1.0, 2);
  f.equilibrium->residual(*f.z, f.s, residual);
  const double slope = f.equilibrium->slope_along_surface(residual, direction);
  const double h = 1e-5;
  Vector plus(*f.z, Teuchos::Copy), minus(*f.z, Teuchos::Copy);
  plus.update(h, direction, 1.0);
  minus.update(-h, direction, 1.0);
  const double difference =
      (f.equilibrium->energy(plus, *f.z, f.s) - f.equilibrium->energy(minus, *f.z, f.s)) / (2.0 * h);
  EXPECT_GT(std::abs(slope), 1e-3);
  EXPECT_NEAR(difference, slope, 1e-6 * std::abs(slope));
}

// The tangent is the derivative of the residual, contact conditions included.
TEST_P(EquilibriumOf, TangentIsTheDerivativeOfTheResidual) {
  Fixture f(GetParam());
  Vector direction(f.z->getMap()), product(f.z->getMap()), plus(f.z->getMap()), minus(f.z->getMap());
  Fixture::shake(direction, 1.0, 3);
  f.equilibrium->linearise(*f.z, f.s);
  f.equilibrium->apply(direction, product);
  const double h = 1e-6;
  Vector z(*f.z, Teuchos::Copy);
  z.update(h, direction, 1.0);
  f.equilibrium->residual(z, f.s, plus);
  z.update(-2.0 * h, direction, 1.0);
  f.equilibrium->residual(z, f.s, minus);
  plus.update(-1.0, minus, 1.0);
  plus.scale(0.5 / h);
  const double size = product.norm2();
  EXPECT_GT(size, 1e-3);
  plus.update(-1.0, product, 1.0);
  EXPECT_LT(plus.norm2(), 1e-6 * size);
}

// The Newton step solves the tangent's system: multiplied by the tangent it gives the right-hand side back.
TEST_P(EquilibriumOf, SolveInvertsTheTangent) {
  Fixture f(GetParam());
  Vector b(f.z->getMap()), step(f.z->getMap()), back(f.z->getMap());
  f.equilibrium->tangent().seek_minimum(false);  // no shift is added
  Fixture::shake(b, 1e-3, 4);
  f.equilibrium->linearise(*f.z, f.s);
  ASSERT_TRUE(f.equilibrium->solve(b, step));
  f.equilibrium->apply(step, back);
  back.update(-1.0, b, 1.0);
  EXPECT_LT(back.norm2(), 1e-8 * b.norm2());
}

// Retraction puts the nodes that were in contact at the last linearisation onto the surface and leaves the others
// alone.
TEST(Equilibrium, RetractionClosesTheGapOfActiveNodes) {
  Fixture f;
  f.equilibrium->linearise(*f.z, f.s);
  const solve::State linearised = f.equilibrium->state(*f.z, f.s);
  Vector moved(*f.z, Teuchos::Copy);
  Fixture::shake(moved, 0.05, 5);
  const solve::State before = f.equilibrium->state(moved, f.s);
  f.equilibrium->retract(moved, f.s);
  const solve::State after = f.equilibrium->state(moved, f.s);
  const body::Surface& surface = *f.sleeve.surface;
  const auto gap = [&](const solve::State& state, size_t c) {
    return surface.closest(state.position[c]).gap - state.offset[c];
  };
  int active = 0, free = 0;
  double largest_before = 0.0;
  for (size_t c = 0; c < f.sleeve.problem.clusters.size(); ++c) {
    if (f.sleeve.problem.clusters[c].size() > 1) continue;  // an open seam touches with the mean of its two sides
    if (after.position[c] == before.position[c]) {
      const bool presses = linearised.contact_force[c] > 0.0 && gap(linearised, c) < 0.0;
      EXPECT_FALSE(presses) << "cluster " << c;
      ++free;
    } else {
      largest_before = std::max(largest_before, std::abs(gap(before, c)));
      EXPECT_LT(std::abs(gap(after, c)), 1e-10) << "cluster " << c;
      ++active;
    }
  }
  EXPECT_GT(active, 10);
  EXPECT_GT(free, 10);
  EXPECT_GT(largest_before, 0.1);
}

// A gap that is not a number on one rank is none on every rank, so that all of them give the step up together.
TEST(Equilibrium, EveryRankSeesAGapThatIsNotANumber) {
  Fixture f;
  Vector residual(f.z->getMap());
  EXPECT_TRUE(std::isfinite(f.equilibrium->residual(*f.z, f.s, residual).imbalance.gap));
  if (Tpetra::getDefaultComm()->getRank() == 0)
    f.z->getDataNonConst()[f.z->getLocalLength() - 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(f.equilibrium->residual(*f.z, f.s, residual).imbalance.gap));
}

// The rate of the residual at the start of a stage, from which the first step is predicted, is that of a finite step:
// LOCA's own difference quotient there is round-off.
TEST_P(EquilibriumOf, RateAtTheStartIsThatOfAStep) {
  Fixture f(GetParam());
  f.equilibrium->set_damping(0.0);
  constexpr double step = 1e-3;
  Vector before(f.z->getMap()), rate(f.z->getMap()), expected(f.z->getMap()), first(f.z->getMap());
  f.equilibrium->residual(*f.z, 0.0, before);
  f.equilibrium->residual(*f.z, step, expected);
  f.equilibrium->residual(*f.z, 2.0 * step, first);
  // Of second order: (-3 f(0) + 4 f(h) - f(2h))/(2h)
  expected.update(-0.5 / step, first, -1.5 / step, before, 2.0 / step);
  f.equilibrium->residual_rate(*f.z, 0.0, rate);
  const double scale = expected.norm2();
  EXPECT_GT(scale, 1e-3);
  rate.update(-1.0, expected, 1.0);
  EXPECT_LT(rate.norm2(), 1e-3 * scale);
}

// A support with a path rests before it, moves between its loads, and rests after it.
TEST(MotionPath, IsPiecewiseLinear) {
  const solve::MotionPath path{{1.0, 2.0, 4.0}, {0.0, 0.5, -0.5}};
  EXPECT_EQ(path.share(-1.0), 0.0);
  EXPECT_EQ(path.share(1.0), 0.0);
  EXPECT_DOUBLE_EQ(path.share(1.5), 0.25);
  EXPECT_DOUBLE_EQ(path.share(3.0), 0.0);
  EXPECT_EQ(path.share(4.0), -0.5);
  EXPECT_EQ(path.share(9.0), -0.5);
  EXPECT_EQ(solve::MotionPath{}.share(0.3), 0.3);
}

// A tangent that cannot be factorised (the second sheet resists nothing at all) is shifted until it can.
TEST(Equilibrium, SingularTangentIsShifted) {
  Panels sheets(
      std::make_shared<material::Material>(*material::find("neo-hookean"), std::vector<double>{8.4667e-3}, 1.0));
  const material::Material limp = limp_fabric();
  sheets.add(solve::Vec3::Zero(), 1.1 * solve::Vec3::UnitX(), 1.1 * solve::Vec3::UnitY(), 0);
  sheets.add(100.0 * solve::Vec3::UnitZ(), solve::Vec3::UnitX(), solve::Vec3::UnitY(), 0);
  sheets.problem.models[1].material = &limp;
  Held held;
  held.position.resize(sheets.problem.clusters.size());
  Equilibrium equilibrium(sheets.problem, placed_state(sheets.problem), held, Drive{}, {}, Tpetra::getDefaultComm());
  const Teuchos::RCP<Vector> z = equilibrium.start_vector();
  Vector b(z->getMap()), step(z->getMap());
  Fixture::shake(b, 1e-3, 4);
  equilibrium.linearise(*z, 0.0);
  EXPECT_EQ(equilibrium.tangent().unshifted_negative_pivots(), -1);
  ASSERT_TRUE(equilibrium.solve(b, step));
  EXPECT_GT(step.dot(b), 0.0);
}

}  // namespace
}  // namespace toile::test
