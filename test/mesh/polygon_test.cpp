#include "toile/mesh/polygon.hpp"

#include <gtest/gtest.h>

namespace toile::mesh {
namespace {

// The signed area is positive counter-clockwise and negative clockwise.
TEST(Polygon, SignedArea) {
  EXPECT_DOUBLE_EQ(signed_area({{1.0, 1.0}, {4.0, 1.0}, {4.0, 3.0}, {1.0, 3.0}}), 6.0);
  EXPECT_DOUBLE_EQ(signed_area({{1.0, 3.0}, {4.0, 3.0}, {4.0, 1.0}, {1.0, 1.0}}), -6.0);
}

// A concave polygon without crossing sides is simple.
TEST(Polygon, ConcaveIsSimple) {
  EXPECT_FALSE(find_self_intersection({{0.0, 0.0}, {10.0, 0.0}, {5.0, 2.0}, {10.0, 8.0}, {0.0, 8.0}}));
}

// A bow tie is found at its crossing.
TEST(Polygon, BowTieIsFoundAtCrossing) {
  const auto at = find_self_intersection({{0.0, 0.0}, {10.0, 10.0}, {10.0, 0.0}, {0.0, 10.0}});
  ASSERT_TRUE(at);
  EXPECT_NEAR((*at - Vec2(5.0, 5.0)).norm(), 0.0, 1e-12);
}

// A corner that touches another side counts as an overlap.
TEST(Polygon, TouchingCornerIsFound) {
  const auto at = find_self_intersection({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {5.0, 0.0}, {0.0, 10.0}});
  ASSERT_TRUE(at);
  EXPECT_NEAR((*at - Vec2(5.0, 0.0)).norm(), 0.0, 1e-12);
}

// A side that runs back over its neighbour counts as an overlap.
TEST(Polygon, FoldedSideIsFound) {
  EXPECT_TRUE(find_self_intersection({{0.0, 0.0}, {10.0, 0.0}, {6.0, 0.0}, {6.0, 5.0}, {0.0, 5.0}}));
}

// Two parts of one straight line that overlap without being neighbours are found.
TEST(Polygon, CollinearOverlapIsFound) {
  EXPECT_TRUE(find_self_intersection({{0.0, 0.0}, {10.0, 0.0}, {10.0, 5.0}, {8.0, 0.0}, {2.0, 0.0}, {0.0, 5.0}}));
}

}  // namespace
}  // namespace toile::mesh
