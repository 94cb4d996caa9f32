#include "toile/base/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace toile::base::test {
namespace {

/// A stage in equal steps whose costs follow `cost` of the parameter: the largest factor, up or down, between what is
/// estimated and what is left, from the third step on.
double worst_factor(const std::function<double(double)>& cost, int steps) {
  std::vector<double> seconds = {3.0};
  for (int k = 0; k < steps; ++k) seconds.push_back(seconds.back() + cost((k + 0.5) / steps));
  PathClock clock;
  clock.start(1.0);
  clock.advance(0.0, seconds[0]);
  double worst = 1.0;
  for (int k = 1; k < steps; ++k) {
    clock.advance(static_cast<double>(k) / steps, seconds[static_cast<std::size_t>(k)]);
    const double right = seconds.back() - seconds[static_cast<std::size_t>(k)];
    const TimeLeft left = clock.left().value();
    if (k >= 3) worst = std::max({worst, left.most / right, right / left.least});
  }
  return worst;
}

// The time that is left is known within a factor of two from the third step on, whether a step always takes as long or
// longer and longer, up to ten and twenty times as long.
TEST(PathClock, FollowsAGrowingCost) {
  for (const int steps : {10, 25}) {
    EXPECT_LT(worst_factor([](double) { return 1.0; }, steps), 1.001);
    EXPECT_LT(worst_factor([](double s) { return 1.0 + 4.0 * s; }, steps), 1.6);
    EXPECT_LT(worst_factor([](double s) { return 1.0 + 9.0 * s; }, steps), 1.8);
    EXPECT_LT(worst_factor([](double s) { return std::exp(3.0 * s); }, steps), 1.9);
  }
}

// The same for steps of a real stage, which grow until the last one (parameter and Newton iterations as recorded).
TEST(PathClock, FollowsGrowingSteps) {
  PathClock clock;
  clock.start(0.0);
  clock.advance(0.0, 74.0);
  clock.advance(0.1, 83.0);
  clock.advance(0.272, 94.0);
  clock.advance(0.559, 100.0);
  EXPECT_GT(clock.left().value().least, 3.0);
  EXPECT_LT(clock.left().value().most, 12.0);  // 6 iterations
  clock.advance(1.0, 106.0);
  EXPECT_EQ(clock.left().value().most, 0.0);
}

// Nothing is known before the first step, whatever the equilibrium at the start took.
TEST(PathClock, KnowsNothingBeforeTheFirstStep) {
  PathClock clock;
  clock.start(0.0);
  EXPECT_FALSE(clock.left().has_value());
  clock.advance(0.0, 100.0);
  EXPECT_FALSE(clock.left().has_value());
  clock.advance(0.5, 101.0);
  EXPECT_DOUBLE_EQ(clock.left().value().least, 1.0);
  EXPECT_DOUBLE_EQ(clock.left().value().most, 1.0);
}

// While an arc follows a falling branch nobody knows when its parameter grows again.
TEST(PathClock, KnowsNothingOnAFallingBranch) {
  PathClock clock;
  clock.start(0.0);
  clock.advance(0.0, 0.0);
  clock.advance(0.5, 1.0);
  EXPECT_TRUE(clock.left().has_value());
  clock.advance(0.4, 2.0);
  EXPECT_FALSE(clock.left().has_value());
  clock.advance(-0.2, 3.0);
  EXPECT_FALSE(clock.left().has_value());
  clock.advance(0.6, 4.0);
  EXPECT_TRUE(clock.left().has_value());
}

/// Whether from step `first` on the time that is left lies between half the least and twice the most estimate.
void expect_bounded(const std::vector<double>& parameter, const std::vector<double>& seconds, std::size_t first) {
  PathClock clock;
  clock.start(0.0);
  for (std::size_t k = 0; k + 1 < parameter.size(); ++k) {
    clock.advance(parameter[k], seconds[k]);
    if (k < first) continue;
    const double right = seconds.back() - seconds[k];
    EXPECT_GT(right, 0.5 * clock.left().value().least) << k;
    EXPECT_LT(right, 2.0 * clock.left().value().most) << k;
  }
}

// Steps that are cut back in the middle of the way, and easy again behind it (two stages as recorded, from the hard
// step on), or ten times slower from there to the end: the time that is left lies between the two that are told.
TEST(PathClock, TellsTwoTimesWhereStepsWereCutBack) {
  expect_bounded({0.0, 0.1, 0.261, 0.522, 0.61, 0.749, 0.894, 1.0}, {2.6, 2.8, 3.0, 3.3, 5.0, 5.6, 5.7, 5.8}, 4);
  expect_bounded({0.0, 0.05, 0.132, 0.249, 0.437, 0.565, 0.747, 1.0}, {2.7, 3.5, 3.7, 3.9, 4.2, 5.1, 5.2, 5.6}, 3);
  std::vector<double> parameter, seconds;
  for (int k = 0; k <= 5; ++k) {
    parameter.push_back(0.1 * k);
    seconds.push_back(k);
  }
  for (int k = 1; k <= 10; ++k) {
    parameter.push_back(0.5 + 0.05 * k);
    seconds.push_back(5.0 + 5.0 * k);
  }
  expect_bounded(parameter, seconds, 6);
}

// A line tells one time, or two that are far apart.
TEST(PathClock, IsToldAsOneTimeOrTwo) {
  ProgressPoint point;
  point.left = TimeLeft{4.0, 5.0};
  EXPECT_NE(progress_line(point).find(", about 4.5 s to 100 %"), std::string::npos);
  point.left = TimeLeft{4.0, 20.0};
  EXPECT_NE(progress_line(point).find(", about 4.0 s or 20.0 s to 100 %"), std::string::npos);
}

// A heartbeat is due when nothing was printed for the interval, and then not before another one has passed.
TEST(Heartbeat, IsDueAfterTheInterval) {
  double now = 100.0;
  Heartbeat heartbeat(5.0, [&now] { return now; });
  EXPECT_FALSE(heartbeat.due());
  now = 104.9;
  EXPECT_FALSE(heartbeat.due());
  heartbeat.line_printed();
  now = 109.8;
  EXPECT_FALSE(heartbeat.due());
  now = 109.9;
  EXPECT_TRUE(heartbeat.due());
  EXPECT_FALSE(heartbeat.due());
  now = 115.0;
  EXPECT_TRUE(heartbeat.due());
}

// A line inside a step tells what is sought, the iteration, its residual against the tolerance, and the time.
TEST(Progress, PrintsAnIteration) {
  IterationPoint point{"sew", 1, 2, 0.342, false, 41, 3, 3.2e-5, 1e-10, 65.0};
  EXPECT_EQ(iteration_line(point),
            "[1/2] sew: seeking 34.2 %, iteration 41, residual 3.2e-05 (tolerance 1.0e-10), 3 cut-backs, 1 min 05 s "
            "elapsed");
  point.relaxing = true;
  point.cut_backs = 0;
  EXPECT_EQ(
      iteration_line(point),
      "[1/2] sew: seeking the final state, iteration 41, residual 3.2e-05 (tolerance 1.0e-10), 1 min 05 s elapsed");
}

// The line shows stage, step, load, iterations, elapsed time and time to the end of the stage's path.
TEST(Progress, PrintsOneLine) {
  const ProgressPoint point{"sew", 1, 2, 7, 0.5, 0.25, 4, 10.0, false, TimeLeft{30.0, 30.0}};
  EXPECT_EQ(progress_line(point),
            "[1/2] sew: step 7, 50.0 %, load 0.2500, 4 iterations, 10.0 s elapsed, about 30.0 s to 100 %");
}

// Nothing is said about the time left while it is not known.
TEST(Progress, SaysNothingUnknown) {
  const ProgressPoint point{"sew", 1, 2, 0, 0.0, 0.0, 0, 0.1};
  EXPECT_EQ(progress_line(point), "[1/2] sew: step 0, 0.0 %, load 0.0000, 0 iterations, 0.1 s elapsed");
}

// Durations are shown in the unit that fits them.
TEST(Progress, ShowsDurations) {
  EXPECT_EQ(duration_text(4.25), "4.2 s");
  EXPECT_EQ(duration_text(59.7), "1 min 00 s");
  EXPECT_EQ(duration_text(185.0), "3 min 05 s");
  EXPECT_EQ(duration_text(7620.0), "2 h 07 min");
}

}  // namespace
}  // namespace toile::base::test
