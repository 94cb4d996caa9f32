#include "seeds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "toile/base/error.hpp"

namespace toile::garment {
namespace {

using ::testing::HasSubstr;

SeededEdge edge(const std::string& name, double length, double size) {
  return {name, length, size, {}, {}};
}

/// Nodes of a part of an edge, as fractions of the part.
Fractions within(const Fractions& all, double from, double to) {
  Fractions part;
  for (const double at : all)
    if (at > from - 1e-9 && at < to + 1e-9) part.push_back((at - from) / (to - from));
  return part;
}

void expect_equal(const Fractions& a, const Fractions& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9);
}

// An edge alone has an even number of equal sides that are no longer than wanted, and nodes where they must lie.
TEST(Seeds, OneEdge) {
  SeededEdge kept = edge("front.hem", 100.0, 9.0);
  expect_equal(plan_seeds({kept}, {})[0], {0.0, 1 / 12.0, 2 / 12.0, 3 / 12.0, 4 / 12.0, 5 / 12.0, 6 / 12.0, 7 / 12.0,
                                           8 / 12.0, 9 / 12.0, 10 / 12.0, 11 / 12.0, 1.0});
  kept.kept = {0.3};
  const Fractions nodes = plan_seeds({kept}, {})[0];
  EXPECT_EQ(within(nodes, 0.0, 0.3).size(), 5u);
  EXPECT_EQ(within(nodes, 0.3, 1.0).size(), 9u);
}

/// An edge of 100 mm with sides of 10 mm, of 1 mm at its end; the length grows over 30 mm.
SeededEdge graded(const std::string& name) {
  SeededEdge result = edge(name, 100.0, 10.0);
  result.finer = [](double at) { return std::min(10.0, 1.0 + 0.3 * (100.0 - 100.0 * at)); };
  return result;
}

/// Each side of a graded edge is as long as is wanted at its middle, or shorter by not more than a third; there is an
/// even number of them.
void expect_graded(const Fractions& nodes) {
  EXPECT_EQ(nodes.size() % 2, 1u);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const double length = 100.0 * (nodes[k] - nodes[k - 1]), wanted = graded("").finer(0.5 * (nodes[k] + nodes[k - 1]));
    EXPECT_LT(length, 1.1 * std::min(10.0, wanted)) << "side " << k;
    EXPECT_GT(length, 0.67 * std::min(10.0, wanted)) << "side " << k;
  }
}

// The nodes of an edge follow the length of sides that is wanted along it.
TEST(Seeds, SidesOfAnEdgeThatIsFinerAtItsEndGrow) {
  expect_graded(plan_seeds({graded("front.hem")}, {})[0]);
}

// What an edge that is finer at its end is sewn to gets its nodes, from either end; a refinement on both sides of the
// seam leaves no short sides between their nodes, and a mesher that dictates its nodes is not asked for others.
TEST(Seeds, GradedEdgesMatchAcrossSeams) {
  for (const bool reversed : {false, true}) {
    const auto nodes =
        plan_seeds({edge("a.side", 100.0, 10.0), graded("b.side")}, {{"side", {0, 0.0, 1.0}, {1, 0.0, 1.0}, reversed}});
    expect_graded(nodes[1]);
    ASSERT_EQ(nodes[0].size(), nodes[1].size());
    for (std::size_t k = 0; k < nodes[0].size(); ++k)
      EXPECT_NEAR(nodes[0][k], reversed ? 1.0 - nodes[1][nodes[1].size() - 1 - k] : nodes[1][k], 1e-9);
  }
  const auto both = plan_seeds({graded("a.side"), graded("b.side")}, {{"side", {0, 0.0, 1.0}, {1, 0.0, 1.0}, false}});
  expect_graded(both[0]);
  expect_equal(both[0], both[1]);
  SeededEdge rows = edge("a.side", 100.0, 10.0);
  for (int k = 0; k <= 8; ++k) rows.dictated.push_back(k / 8.0);
  expect_equal(plan_seeds({rows, graded("b.side")}, {{"side", {0, 0.0, 1.0}, {1, 0.0, 1.0}, false}})[1], rows.dictated);
}

// Edges that are sewn get the same nodes, those of the finer one, also when one runs the other way.
TEST(Seeds, SewnEdgesMatch) {
  for (const bool reversed : {false, true}) {
    SeededEdge fine = edge("a.side", 80.0, 5.0);
    fine.kept = {0.25};
    const auto nodes =
        plan_seeds({fine, edge("b.side", 90.0, 20.0)}, {{"side", {0, 0.0, 1.0}, {1, 0.0, 1.0}, reversed}});
    Fractions other = nodes[1];
    if (reversed)
      for (std::size_t k = 0; k < other.size(); ++k) other[k] = 1.0 - nodes[1][nodes[1].size() - 1 - k];
    expect_equal(nodes[0], other);
  }
}

// A sleeve cap is sewn to two armholes; a part of it gets the nodes of its partner, and what a third panel asks of that
// partner arrives too.
TEST(Seeds, PartsAndChainsMatch) {
  SeededEdge third = edge("yoke.side", 60.0, 10.0);
  third.kept = {0.5};
  const auto nodes = plan_seeds(
      {edge("sleeve.cap", 120.0, 10.0), edge("front.armhole", 60.0, 4.0), edge("back.armhole", 66.0, 12.0), third},
      {{"front", {0, 0.0, 0.5}, {1, 0.0, 1.0}, false},
       {"back", {0, 0.5, 1.0}, {2, 0.0, 1.0}, true},
       {"yoke", {2, 0.0, 1.0}, {3, 0.0, 1.0}, false}});
  expect_equal(within(nodes[0], 0.0, 0.5), nodes[1]);
  Fractions cap = within(nodes[0], 0.5, 1.0);
  std::reverse(cap.begin(), cap.end());
  for (double& at : cap) at = 1.0 - at;
  expect_equal(cap, nodes[2]);
  expect_equal(nodes[2], nodes[3]);
  EXPECT_EQ(within(nodes[1], 0.0, 1.0).size(), 17u);
}

// Nodes that rows of elements dictate are taken over, graded as they are.
TEST(Seeds, DictatedNodesAreKept) {
  SeededEdge rows = edge("front.left", 100.0, 25.0);
  rows.dictated = {0.0, 0.1, 0.3, 0.6, 1.0};
  const auto nodes = plan_seeds({rows, edge("back.side", 100.0, 3.0)}, {{"side", {0, 0.0, 1.0}, {1, 0.0, 1.0}, false}});
  expect_equal(nodes[1], rows.dictated);
  rows.dictated = {0.0, 0.5, 1.0};
  SeededEdge other = edge("back.left", 100.0, 3.0);
  other.kept = {0.25};
  try {
    plan_seeds({rows, other}, {{"side", {0, 0.0, 1.0}, {1, 0.0, 1.0}, false}});
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("edge \"front.left\" has 3 nodes in rows of elements"));
  }
}

// Seams that carry the ends of parts round and round are refused.
TEST(Seeds, EndlessSeamsAreRefused) {
  try {
    const double turn = 0.38196601125;
    plan_seeds({edge("a.ring", 100.0, 5.0), edge("b.ring", 100.0, 5.0)},
               {{"straight", {0, 0.0, 1.0}, {1, 0.0, 1.0}, false},
                {"turned", {0, 0.0, turn}, {1, 1.0 - turn, 1.0}, false},
                {"rest", {0, turn, 1.0}, {1, 0.0, 1.0 - turn}, false}});
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("carry the ends of parts from edge to edge without end"));
  }
}

// Two zones that end 0.02 mm beside each other on either side of a seam are refused with the edge and the place.
TEST(Seeds, RefusesASliver) {
  SeededEdge front = edge("front.side", 100.0, 9.0), back = edge("back.side", 100.0, 9.0);
  front.kept = {0.3};
  back.kept = {0.3002};
  const std::vector<SeededSeam> seam = {{"side", {0, 0.0, 1.0}, {1, 0.0, 1.0}, false}};
  try {
    plan_seeds({front, back}, seam);
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("edge \"front.side\" needs two nodes that are 0.02 mm apart, at 30 mm"));
  }
}

}  // namespace
}  // namespace toile::garment
