#include "toile/base/memory.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace toile::base {
namespace {

// What is written to counts, in MB, and stays counted when it is given back.
TEST(Memory, HoldsWhatWasWritten) {
  const double before = peak_memory();
  {
    const std::vector<char> block(200000000, 'x');
    EXPECT_EQ(block[123456789], 'x');
  }
  EXPECT_GT(before, 1.0);
  EXPECT_NEAR(peak_memory() - before, 200.0, 20.0);
}

}  // namespace
}  // namespace toile::base
