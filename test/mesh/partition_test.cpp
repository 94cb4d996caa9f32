#include "toile/mesh/partition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "toile/base/error.hpp"
#include "toile/mesh/four_sided.hpp"

namespace toile::mesh {
namespace {

constexpr int along = 30;

/// Two panels of 16 x 30 elements.
Mesh two_panels(bool triangles = false) {
  GridOptions options;
  options.across = 16;
  options.along = along;
  options.triangles = triangles;
  Mesh mesh;
  for (const char* name : {"front", "back"}) {
    const Grid grid = mesh_four_sided(name, rectangle(80.0, 300.0), options);
    const std::vector<Vec3> anywhere(grid.nodes.size(), Vec3::Zero());
    add_panel(mesh, name, panel_mesh(grid), {anywhere, anywhere}, {{"", {"knit", 0.0}}});
  }
  return mesh;
}

/// Clusters of a tube: the panels are sewn to each other along both sides.
std::vector<int> tube_clusters(const Mesh& mesh) {
  std::vector<int> master(mesh.nodes());
  std::iota(master.begin(), master.end(), 0);
  for (int j = 0; j <= along; ++j) {
    master[mesh.edges.at("back.left")[j]] = mesh.edges.at("front.right")[j];
    master[mesh.edges.at("back.right")[j]] = mesh.edges.at("front.left")[j];
  }
  std::vector<int> number(mesh.nodes(), -1), cluster(mesh.nodes());
  int count = 0;
  for (int node = 0; node < mesh.nodes(); ++node) {
    if (number[master[node]] < 0) number[master[node]] = count++;
    cluster[node] = number[master[node]];
  }
  return cluster;
}

std::vector<int> element_nodes(const Mesh& mesh, int element) {
  for (const Block& block : mesh.blocks) {
    if (element < block.size()) {
      const auto first = block.connectivity.begin() + element * block.nodes_per_element;
      return {first, first + block.nodes_per_element};
    }
    element -= block.size();
  }
  return {};
}

// Every element gets a rank, and no rank has more than 15 % above the mean or stays without work.
TEST(Partition, ElementsAreBalanced) {
  for (const bool triangles : {false, true}) {
    const Mesh mesh = two_panels(triangles);
    for (const int ranks : {2, 3, 4, 7}) {
      const Partition split = partition(mesh, tube_clusters(mesh), ranks);
      ASSERT_EQ(static_cast<int>(split.element_rank.size()), mesh.elements());
      std::vector<int> load(ranks, 0);
      for (const int rank : split.element_rank) ++load.at(rank);
      const double mean = static_cast<double>(mesh.elements()) / ranks;
      EXPECT_LE(*std::max_element(load.begin(), load.end()), 1.15 * mean);
      EXPECT_GE(*std::min_element(load.begin(), load.end()), 0.85 * mean);
    }
  }
}

// The owner of a cluster has an element that touches it, so seam partners have one owner that works on them.
TEST(Partition, OwnerTouchesItsCluster) {
  const Mesh mesh = two_panels();
  const std::vector<int> cluster = tube_clusters(mesh);
  const Partition split = partition(mesh, cluster, 4);
  ASSERT_EQ(static_cast<int>(split.cluster_rank.size()), mesh.nodes() - 2 * (along + 1));
  std::vector<bool> touched(split.cluster_rank.size(), false);
  for (int e = 0; e < mesh.elements(); ++e) {
    for (const int node : element_nodes(mesh, e)) {
      if (split.element_rank[e] == split.cluster_rank[cluster[node]]) touched[cluster[node]] = true;
    }
  }
  EXPECT_EQ(std::count(touched.begin(), touched.end(), false), 0);
}

// Elements on both sides of a seam are neighbours for the partitioner: the closed tube is cut across, not along.
TEST(Partition, SeamsAreNotCutFirst) {
  const Mesh mesh = two_panels();
  const Partition split = partition(mesh, tube_clusters(mesh), 2);
  int different = 0;
  for (int j = 0; j < along; ++j) {
    const int front_right = j * 16 + 15;
    const int back_left = 16 * along + j * 16;
    if (split.element_rank[front_right] != split.element_rank[back_left]) ++different;
  }
  EXPECT_LE(different, 3);
}

// The same arguments give the same partition.
TEST(Partition, IsDeterministic) {
  const Mesh mesh = two_panels();
  const Partition first = partition(mesh, tube_clusters(mesh), 4);
  const Partition second = partition(mesh, tube_clusters(mesh), 4);
  EXPECT_EQ(first.element_rank, second.element_rank);
  EXPECT_EQ(first.cluster_rank, second.cluster_rank);
}

// On one rank everything belongs to rank 0.
TEST(Partition, OneRankOwnsAll) {
  const Mesh mesh = two_panels();
  const Partition split = partition(mesh, tube_clusters(mesh), 1);
  EXPECT_THAT(split.element_rank, ::testing::Each(0));
  EXPECT_THAT(split.cluster_rank, ::testing::Each(0));
  EXPECT_EQ(static_cast<int>(split.element_rank.size()), mesh.elements());
}

// More ranks than elements are refused with both numbers.
TEST(Partition, TooManyRanksAreRefused) {
  Mesh mesh;
  const Grid grid = mesh_four_sided("patch", rectangle(1.0, 1.0), {});
  const std::vector<Vec3> anywhere(4, Vec3::Zero());
  add_panel(mesh, "patch", panel_mesh(grid), {anywhere, anywhere}, {{"", {"knit", 0.0}}});
  try {
    partition(mesh, {0, 1, 2, 3}, 2);
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "the garment has 1 elements, too few for 2 ranks: start fewer processes or refine the panels");
  }
}

}  // namespace
}  // namespace toile::mesh
