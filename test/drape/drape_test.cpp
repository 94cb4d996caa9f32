#include "toile/drape/drape.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "toile/body/analytic.hpp"

namespace toile::drape {
namespace {

using mesh::Vec3;

/// Two flat panels of `width` x 60 mm, in front of and behind a cylinder about z, sewn at both sides.
struct Tube {
  static constexpr int across = 14, along = 6;
  mesh::Mesh mesh;
  std::vector<std::vector<int>> clusters;

  explicit Tube(double width, double distance = 90.0) {
    for (const int panel : {0, 1}) {
      mesh::Block block;
      block.panel = panel;
      for (int j = 0; j <= along; ++j)
        for (int i = 0; i <= across; ++i) {
          const double x = width * (static_cast<double>(i) / across - 0.5), z = 10.0 * j;
          mesh.pattern.emplace_back(x, z);
          // The back panel looks the other way, so that its x runs back.
          mesh.placed.emplace_back(panel == 0 ? x : -x, panel == 0 ? -distance : distance, z);
          mesh.normal.emplace_back(0.0, panel == 0 ? -1.0 : 1.0, 0.0);
        }
      for (int j = 0; j < along; ++j)
        for (int i = 0; i < across; ++i)
          for (const int n :
               {node(panel, i, j), node(panel, i + 1, j), node(panel, i + 1, j + 1), node(panel, i, j + 1)})
            block.connectivity.push_back(n);
      block.wale_angle.assign(block.connectivity.size() / 4, M_PI_2);
      mesh.blocks.push_back(block);
      mesh.panels.push_back({panel == 0 ? "front" : "back", node(panel, 0, 0), node(1, 0, 0), across, {}});
    }
    for (int j = 0; j <= along; ++j) {
      clusters.push_back({node(0, 0, j), node(1, across, j)});
      clusters.push_back({node(0, across, j), node(1, 0, j)});
    }
    for (const int panel : {0, 1})
      for (int j = 0; j <= along; ++j)
        for (int i = 1; i < across; ++i) clusters.push_back({node(panel, i, j)});
  }
  static int node(int panel, int i, int j) { return (panel * (along + 1) + j) * (across + 1) + i; }

  double girth(int j) const {
    double sum = 0.0;
    for (const int panel : {0, 1})
      for (int i = 0; i < across; ++i)
        sum += (mesh.placed[node(panel, i + 1, j)] - mesh.placed[node(panel, i, j)]).norm();
    return sum;
  }
};

constexpr double radius = 50.0;

// A tube wide enough for its body comes round it with closed seams, unstretched, outside of it, its right side out.
TEST(Drape, TubeComesRoundACylinder) {
  Tube tube(175.0);
  const body::SurfacePtr cylinder = body::elliptic_cylinder(radius, radius, {});
  const Outcome outcome = drape(tube.mesh, tube.clusters, {}, *cylinder, {});
  EXPECT_LT(outcome.largest_opening, 0.2);
  EXPECT_LT(outcome.largest_stretch, 1.03);
  for (const std::vector<int>& cluster : tube.clusters)
    for (const int n : cluster) EXPECT_EQ(tube.mesh.placed[n], tube.mesh.placed[cluster.front()]);
  for (std::size_t n = 0; n < tube.mesh.placed.size(); ++n) {
    const body::SurfacePoint foot = cylinder->closest(tube.mesh.placed[n]);
    EXPECT_GT(foot.gap, 0.95) << n;
    EXPECT_GT(foot.normal.dot(tube.mesh.normal[n]), 0.5) << n;
  }
  for (int j = 0; j <= Tube::along; ++j) EXPECT_NEAR(tube.girth(j), 350.0, 3.5);
}

// One that is too narrow by a fifth closes all the same, evenly stretched onto the body.
TEST(Drape, NarrowTubeIsStretched) {
  const double width = M_PI * (radius + 1.0) / 1.2;
  Tube tube(width);
  const Outcome outcome = drape(tube.mesh, tube.clusters, {}, *body::elliptic_cylinder(radius, radius, {}), {});
  EXPECT_LT(outcome.largest_opening, 0.2);
  EXPECT_NEAR(tube.girth(3) / (2.0 * width), 1.2, 0.01);
  EXPECT_LT(outcome.largest_stretch, 1.25);
}

// A tube that is half as wide as its body lies evenly round it after few rounds if the stretch that it will have is
// told.
TEST(Drape, TightTubeIsEven) {
  const auto unevenness = [](double told) {
    Tube tube(M_PI * (radius + 1.0) / 2.0);
    Options options;
    options.most_rounds = 400;
    options.stretch_course = told;
    const body::SurfacePtr cylinder = body::elliptic_cylinder(radius, radius, {});
    const Outcome outcome = drape(tube.mesh, tube.clusters, {}, *cylinder, options);
    EXPECT_LT(outcome.largest_opening, 0.2);
    return outcome.largest_stretch - 2.0;
  };
  EXPECT_LT(unevenness(2.0), 0.05);
  EXPECT_GT(unevenness(1.0), 0.15);
}

// An edge that is held in height stays at its height, while the rest of the tube settles where it may.
TEST(Drape, HeldEdgeKeepsItsHeight) {
  Tube tube(130.0);
  std::vector<Held> held;
  for (const int panel : {0, 1})
    for (int i = 0; i <= Tube::across; ++i)
      for (const int j : {0, Tube::along}) held.push_back({Tube::node(panel, i, j), mesh::Vec3::UnitZ()});
  drape(tube.mesh, tube.clusters, held, *body::elliptic_cylinder(radius, radius, {}), {});
  for (const Held& h : held) EXPECT_DOUBLE_EQ(tube.mesh.placed[h.node].z(), tube.mesh.pattern[h.node].y());
}

// Rounds that do not suffice leave a seam open, and the outcome says which.
TEST(Drape, TooFewRoundsLeaveASeamOpen) {
  Tube tube(175.0);
  Options few;
  few.most_rounds = 10;
  const Outcome outcome = drape(tube.mesh, tube.clusters, {}, *body::elliptic_cylinder(radius, radius, {}), few);
  EXPECT_EQ(outcome.rounds, 10);
  EXPECT_GT(outcome.largest_opening, 50.0);
  ASSERT_GE(outcome.widest, 0);
  EXPECT_EQ(tube.clusters[static_cast<std::size_t>(outcome.widest)].size(), 2U);
}

}  // namespace
}  // namespace toile::drape
