#include "toile/base/log.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace toile::base::test {
namespace {

// Information goes to the one stream and warnings to the other.
TEST(Log, SeparatesInformationFromWarnings) {
  std::ostringstream out, err;
  Log log(out, err);
  log.info("step 1");
  log.warn("fabric is overstretched");
  EXPECT_EQ(out.str(), "step 1\n");
  EXPECT_EQ(err.str(), "warning: fabric is overstretched\n");
}

// A warning that is given twice is printed once and stands in the summary once.
TEST(Log, PrintsAWarningOnce) {
  std::ostringstream out, err;
  Log log(out, err);
  log.warn("a");
  log.warn("b");
  log.warn("a");
  EXPECT_EQ(err.str(), "warning: a\nwarning: b\n");
  EXPECT_EQ(log.warnings(), (std::vector<std::string>{"a", "b"}));
}

// Quiet suppresses information, not warnings.
TEST(Log, QuietKeepsWarnings) {
  std::ostringstream out, err;
  Log log(out, err, true);
  log.info("step 1");
  log.overwrite("50 %");
  log.warn("a");
  EXPECT_EQ(out.str(), "");
  EXPECT_EQ(err.str(), "warning: a\n");
  EXPECT_FALSE(log.prints());
}

// A log of another rank than 0 keeps warnings and prints nothing.
TEST(Log, OtherRanksOnlyCollect) {
  Log log;
  log.info("step 1");
  log.warn("a");
  EXPECT_FALSE(log.prints());
  EXPECT_EQ(log.warnings().size(), 1u);
}

// A line that is overwritten is blanked out to its end, and ended before anything else is printed.
TEST(Log, OverwritesAndEndsTheLine) {
  std::ostringstream out, err;
  Log log(out, err);
  log.overwrite("100 %");
  log.overwrite("5 %");
  log.info("done");
  log.overwrite("");
  EXPECT_EQ(out.str(), "\r100 %\r5 %  \ndone\n");
}

}  // namespace
}  // namespace toile::base::test
