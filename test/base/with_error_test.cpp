#include "toile/base/with_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace toile::base::test {
namespace {

// A value has the decimals of the first digit of its error, and those asked for at least.
TEST(WithError, HasTheDecimalsOfTheError) {
  EXPECT_EQ(with_error(13.44, 0.2), "13.4 +- 0.2");
  EXPECT_EQ(with_error(134.4, 12.0), "134 +- 12");
  EXPECT_EQ(with_error(2.8, 0.15, 3), "2.800 +- 0.150");
  EXPECT_EQ(with_error(2.8, 0.0, 3), "2.800 +- 0.000");
}

// An error that is not 0 never looks like 0, however small it is.
TEST(WithError, OfASmallErrorIsNotZero) {
  EXPECT_EQ(with_error(0.183, 0.0004, 3), "0.1830 +- 0.0004");
  EXPECT_EQ(with_error(0.183, 0.00002), "0.18300 +- 0.00002");
  EXPECT_EQ(with_error(0.183, 2e-9, 3), "0.183 +- 2e-09");
}

// What is not known is said so.
TEST(WithError, OfNoNumber) {
  EXPECT_EQ(with_error(0.5, INFINITY, 1), "0.5 +- inf");
}

}  // namespace
}  // namespace toile::base::test
