#include "toile/base/progress.hpp"

#include <gtest/gtest.h>

namespace toile::base::test {
namespace {

// The time that is left extends what the run took so far over the stages that remain.
TEST(Progress, EstimatesTheTimeLeft) {
  ProgressPoint point;
  point.stages = 2;
  EXPECT_FALSE(time_left(point).has_value());
  point.parameter = 0.5;
  point.seconds = 10.0;
  EXPECT_DOUBLE_EQ(time_left(point).value(), 30.0);
  point.stage_number = 2;
  point.parameter = 1.0;
  EXPECT_DOUBLE_EQ(time_left(point).value(), 0.0);
}

// The line shows stage, step, load, iterations, elapsed time and time left.
TEST(Progress, PrintsOneLine) {
  const ProgressPoint point{"sew", 1, 2, 7, 0.5, 0.25, 4, 10.0};
  EXPECT_EQ(progress_line(point),
            "[1/2] sew: step 7, 50.0 %, load 0.2500, 4 iterations, 10.0 s elapsed, about 30.0 s left");
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
