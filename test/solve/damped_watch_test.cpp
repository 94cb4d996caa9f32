// What the damping of a stage does to its path.
#include "watch/damped_watch.hpp"

#include <gmock/gmock.h>

#include "toile/solve/stage_kind.hpp"

namespace toile::test {
namespace {

using solve::DampedStep;
using solve::DampedWatch;
using solve::State;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

State at(double load, double x) {
  State state;
  state.load = load;
  state.position = {{x, 0.0, 0.0}};
  return state;
}

DampedWatch watch() {
  solve::StageOptions stage;
  stage.kind = &solve::stage_kind("load");
  stage.damping.active = true;
  return DampedWatch(stage);
}

/// Ten steps of 1 mm; those up to `until` dissipate as much as the garment stores.
DampedWatch ten_steps(int until) {
  DampedWatch watched = watch();
  for (int k = 0; k < 10; ++k) {
    const State before = at(0.1 * k, k), after = at(0.1 * (k + 1), k + 1);
    watched.accepted({before, after, 0.1 * k, 0.1 * (k + 1), k < until ? 2.0 : 1e-4, 2.0});
  }
  return watched;
}

// Damping that takes as much as the garment stores, over more than a quarter of a stage, holds it back: said with where
// and how much. Over less it is a snap.
TEST(DampedStage, AGarmentThatIsHeldBackIsTold) {
  EXPECT_THAT(ten_steps(4).warnings(), ElementsAre(AllOf(HasSubstr("in 4 steps between load 0 and 0.4"),
                                                         HasSubstr("took 8 N mm: it held the garment back"))));
  EXPECT_THAT(ten_steps(2).warnings(), ElementsAre(HasSubstr("snapped")));
  EXPECT_THAT(ten_steps(0).warnings(), IsEmpty());
}

// A step that dissipates a hundredth of the strain energy and ten times what is asked of it is a snap: said with its
// loads, its way and its energy.
TEST(DampedStage, ASnapIsTold) {
  DampedWatch watched = watch();
  const State before = at(0.3, 2.0), after = at(0.4, 14.0), later = at(0.5, 14.5);
  EXPECT_TRUE(watched.accepted({before, after, 0.3, 0.4, 0.5, 2.0}));
  EXPECT_FALSE(watched.accepted({after, later, 0.4, 0.5, 1e-3, 2.0}));
  EXPECT_THAT(watched.warnings(), ElementsAre(AllOf(HasSubstr("between load 0.3 and 0.4 the garment snapped"),
                                                    HasSubstr("moved by 12 mm"), HasSubstr("0.5 N mm, 25 %"))));
}

}  // namespace
}  // namespace toile::test
