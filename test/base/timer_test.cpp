#include "toile/base/timer.hpp"

#include <gmock/gmock.h>

#include <thread>

namespace toile::base::test {
namespace {

void wait(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

// Phases nest where they are entered inside each other, and keep the order in which they were first entered.
TEST(Timer, NestsPhases) {
  Timer timer;
  {
    const auto solve = timer.phase("solve");
    { const auto assemble = timer.phase("assemble"); }
    { const auto factor = timer.phase("factor"); }
    { const auto assemble = timer.phase("assemble"); }
  }
  { const auto write = timer.phase("write"); }
  const auto phases = timer.phases();
  ASSERT_EQ(phases.size(), 4u);
  EXPECT_EQ(phases[0].name, "solve");
  EXPECT_EQ(phases[1].name, "assemble");
  EXPECT_EQ(phases[1].depth, 1);
  EXPECT_EQ(phases[1].calls, 2);
  EXPECT_EQ(phases[2].name, "factor");
  EXPECT_EQ(phases[3].name, "write");
  EXPECT_EQ(phases[3].depth, 0);
}

// A phase takes the wall time of its scope, inner phases included, added up over its calls.
TEST(Timer, AddsUpWallTime) {
  Timer timer;
  for (int i = 0; i < 2; ++i) {
    const auto outer = timer.phase("outer");
    const auto inner = timer.phase("inner");
    wait(5);
  }
  const auto phases = timer.phases();
  EXPECT_GE(phases[1].seconds, 0.010);
  EXPECT_GE(phases[0].seconds, phases[1].seconds);
  EXPECT_GE(timer.elapsed(), phases[0].seconds);
}

// An exception that leaves a scope ends its phase.
TEST(Timer, EndsAPhaseOnExceptions) {
  Timer timer;
  try {
    const auto outer = timer.phase("outer");
    throw 1;
  } catch (int) {
  }
  { const auto next = timer.phase("next"); }
  EXPECT_EQ(timer.phases().at(1).depth, 0);
}

// The table has one line a phase, indented by depth, and the total last.
TEST(Timer, PrintsATable) {
  Timer timer;
  {
    const auto outer = timer.phase("solve");
    const auto inner = timer.phase("factor");
  }
  const std::string table = timer.table();
  EXPECT_THAT(table, ::testing::MatchesRegex("solve .* s .* %.*1x\n  factor .* s .* %.*1x\ntotal .* s  100.0 %\n"));
}

}  // namespace
}  // namespace toile::base::test
