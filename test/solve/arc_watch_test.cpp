// What the turns of an arc do to it.
#include "watch/arc_watch.hpp"

#include <gmock/gmock.h>

#include "panels.hpp"
#include "stages.hpp"

namespace toile::test {
namespace {

using solve::ArcWatch;
using solve::Vector;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// An arc whose states are put down by hand: `walk` adds to two components of a sleeve's state, told apart by their
/// number so that any number of ranks walks the same way.
struct Walk {
  Sleeve sleeve{options(12, 4), neo_hookean()};
  std::shared_ptr<solve::Equilibrium> equilibrium;
  Teuchos::RCP<Vector> z;
  std::unique_ptr<ArcWatch> watch;

  Walk() {
    solve::Held held;
    held.position.resize(sleeve.problem.clusters.size());
    const solve::State start = closed_start(sleeve.problem);
    equilibrium = std::make_shared<solve::Equilibrium>(sleeve.problem, start, held, solve::Drive{0.0, 1.0, 0.0, 1.0},
                                                       solve::SolverOptions(), Tpetra::getDefaultComm());
    z = equilibrium->start_vector();
    solve::StageOptions options = stage("load");
    options.first_step = 0.1;
    options.smallest_step = 1e-4;
    watch = std::make_unique<ArcWatch>(equilibrium, options);
    step(0.0, 0.0, 0.0);
  }

  /// Whether the step counts; it is accepted then, at the load s, and whether it turned off is kept.
  bool step(double dx, double dy, double s) {
    const Teuchos::RCP<Vector> next = Teuchos::rcp(new Vector(*z, Teuchos::Copy));
    for (const auto& [number, change] : {std::make_pair(0, dx), std::make_pair(1, dy)})
      if (next->getMap()->isNodeGlobalElement(number)) next->sumIntoGlobalValue(number, change);
    if (!watch->accepts(*next)) return false;
    turned = watch->accepted(*next, s);
    z = next;
    return true;
  }

  bool turned = false;
};

// A smooth path, and a bend that is taken in short steps, are accepted without a word.
TEST(ArcWatch, SaysNothingOfASmoothPath) {
  Walk walk;
  for (int k = 1; k <= 8; ++k) {
    const double angle = 0.4 * k;  // 23 degrees a step
    EXPECT_TRUE(walk.step(std::cos(angle), std::sin(angle), 0.1 * k));
    EXPECT_FALSE(walk.turned);
  }
  EXPECT_THAT(walk.watch->warning(), IsEmpty());
}

// A step that turns back along the path is refused until it is a twentieth of the first one: then it is accepted, and
// told with its loads and its angle.
TEST(ArcWatch, TellsASharpTurn) {
  Walk walk;
  EXPECT_TRUE(walk.step(1.0, 0.0, 0.1));
  EXPECT_TRUE(walk.step(1.0, 0.0, 0.2));
  EXPECT_FALSE(walk.step(-1.0, 0.0, 0.1));
  EXPECT_FALSE(walk.step(-0.1, 0.0, 0.19));
  EXPECT_TRUE(walk.step(-0.04, 0.0, 0.196));
  EXPECT_TRUE(walk.turned);
  EXPECT_THAT(walk.watch->warning(), AllOf(HasSubstr("the path turned by 180 degrees at once"), HasSubstr("smaller")));
}

}  // namespace
}  // namespace toile::test
