#include "toile/study/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace toile::study {
namespace {

using base::Reals;

template <class F>
Reals values(const Reals& sizes, const F& f) {
  Reals all;
  for (const double h : sizes) all.push_back(f(h));
  return all;
}

// Results 2 + 0.3 h^p of three meshes of any sizes have the limit 2 and the order p.
TEST(Extrapolation, FindsLimitAndOrder) {
  for (const double p : {1.0, 1.5, 2.0, 4.0})
    for (const Reals& sizes : {Reals{4, 2, 1}, Reals{3, 2.5, 1}}) {
      const Extrapolation e = extrapolate(sizes, values(sizes, [p](double h) { return 2.0 + 0.3 * std::pow(h, p); }));
      EXPECT_TRUE(e.trusted) << e.why;
      EXPECT_NEAR(e.order, p, 1e-9);
      EXPECT_NEAR(e.value, 2.0, 1e-10);
      EXPECT_TRUE(std::isnan(e.order_spread)) << "three meshes do not tell how far the order is off";
    }
}

// With a second term the order is that of the finest meshes only; the limit is within the error that is told, and that
// is below the difference of the two finest meshes.
TEST(Extrapolation, ErrorHoldsTheLimit) {
  const Reals sizes = {8, 4, 2, 1};
  for (const double c : {-0.1, 0.05, 0.2}) {
    const Reals f = values(sizes, [c](double h) { return 1.0 + 0.01 * h * h + 0.002 * c * h * h * h; });
    const Extrapolation e = extrapolate(sizes, f);
    ASSERT_TRUE(e.trusted) << e.why;
    EXPECT_LE(std::abs(e.value - 1.0), e.uncertainty);
    EXPECT_LT(e.uncertainty, std::abs(f[2] - f[3]));
    EXPECT_GT(e.order_spread, 0.0);
  }
}

// Results that swing, converge too slowly, or change their order are not trusted, and the reason is told.
TEST(Extrapolation, SaysWhenItIsNotTrusted) {
  const Reals sizes = {4, 2, 1};
  EXPECT_EQ(extrapolate(sizes, {1.0, 1.2, 1.1}).why, "the three finest meshes do not converge from one side");
  EXPECT_EQ(extrapolate(sizes, {1.0, 1.1, 1.3}).why, "the three finest meshes do not converge from one side");
  EXPECT_EQ(extrapolate(sizes, {1.0, 1.2, 1.35}).why, "the observed order is 0.42");
  EXPECT_EQ(extrapolate({8, 4, 2, 1}, {1.0, 1.1, 1.2, 1.225}).why,
            "the observed order is not the same on coarser meshes");
  EXPECT_EQ(extrapolate({2, 1}, {1.0, 1.1}).why, "it needs three meshes");
  const Extrapolation swings = extrapolate(sizes, {1.0, 1.2, 1.1});
  EXPECT_FALSE(swings.trusted);
  EXPECT_DOUBLE_EQ(swings.value, 1.1);
  EXPECT_NEAR(swings.uncertainty, 0.6, 1e-12) << "three times the range";
}

// A high order that coarser meshes do not have is one of chance: the force of a ball under a sheet (N), whose limit, of
// meshes up to four times finer, is 3.432, was told to be 3.391 +- 0.011.
TEST(Extrapolation, HighOrdersNeedToBeConfirmed) {
  const Extrapolation e = extrapolate({1.0 / 14, 1.0 / 20, 1.0 / 30, 1.0 / 40}, {2.95651, 3.21253, 3.33769, 3.36855});
  EXPECT_FALSE(e.trusted);
  EXPECT_EQ(e.why, "the observed order is 2.96, and not the same on coarser meshes");
  EXPECT_NEAR(e.value, 3.432, e.uncertainty);
}

// Meshes that agree to what equations are solved to have no order, and their value is the limit.
TEST(Extrapolation, MeshesThatAgree) {
  const Extrapolation e = extrapolate({4, 2, 1}, {1.0, 1.0 + 1e-10, 1.0 - 1e-10});
  EXPECT_TRUE(e.trusted);
  EXPECT_TRUE(std::isnan(e.order));
  EXPECT_LE(e.uncertainty, 3e-10);
}

}  // namespace
}  // namespace toile::study
