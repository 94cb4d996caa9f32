#include "toile/base/units.hpp"

#include <gtest/gtest.h>

namespace toile::base::test {
namespace {

// Pressures are shown in kPa and in millimetres of mercury (133.3224 Pa).
TEST(Units, ConvertPressure) {
  EXPECT_DOUBLE_EQ(mpa_to_kpa(0.0025), 2.5);
  EXPECT_NEAR(mpa_to_mmhg(133.3224e-6), 1.0, 1e-6);
}

}  // namespace
}  // namespace toile::base::test
