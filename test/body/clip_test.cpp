#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "body/import_support.hpp"
#include "body/meshes.hpp"
#include "toile/body/import.hpp"

namespace toile::body {
namespace {

using test::ball;
using test::twins;

// Only triangles in the box stay; with a seed only the piece nearest to it.
TEST(Clip, KeepsTheWantedPiece) {
  const TriangleMesh one = ball();
  const TriangleMesh two = twins(Vec3(150.0, 0.0, 0.0));
  Region region;
  EXPECT_EQ(clip(two, region).triangles.size(), two.triangles.size());
  region.seed = Vec3(140.0, 10.0, 0.0);
  const TriangleMesh right = clip(two, region);
  EXPECT_EQ(right.triangles.size(), one.triangles.size());
  EXPECT_EQ(right.vertices.size(), one.vertices.size());
  for (const Vec3& v : right.vertices) EXPECT_GT(v.x(), 80.0);
  region.lower.z() = 20.0;
  region.upper.z() = 40.0;
  const TriangleMesh band = clip(two, region);
  EXPECT_LT(band.triangles.size(), one.triangles.size() / 2);
  EXPECT_GT(band.triangles.size(), 0u);
  region.lower.z() = 200.0;
  region.upper.z() = 300.0;
  EXPECT_TRUE(clip(two, region).triangles.empty());
}

/// Two tubes side by side, from z = 0 to 200, joined by facets above them that share vertices at z = 210 and 250.
TriangleMesh trousers() {
  const TriangleMesh leg = test::random_triangulation(test::elliptic_tube(40.0, 40.0, 200.0), 20.0, 1);
  TriangleMesh mesh;
  std::vector<int> tops;
  for (const double side : {-1.0, 1.0}) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& v : leg.vertices) mesh.vertices.push_back(v + Vec3(60.0 * side, 0.0, 0.0));
    for (const auto& t : leg.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    tops.push_back(first + static_cast<int>(leg.vertices.size()) - 1);
  }
  const int crotch = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(0.0, 0.0, 210.0);
  mesh.vertices.emplace_back(0.0, 0.0, 250.0);
  for (const int top : tops) {
    mesh.triangles.push_back({top, top - 1, crotch});
    mesh.triangles.push_back({top, crotch, crotch + 1});
  }
  return mesh;
}

// Pieces that are joined outside of the bounds only are different pieces, and the margin continues the wanted one
// outside without coming back down the other.
TEST(Clip, MarginContinuesOnePieceOnly) {
  const TriangleMesh mesh = trousers();
  Region region;
  region.bottom = 50.0;
  region.top = 190.0;
  region.seed = Vec3(60.0, 0.0, 120.0);
  const auto extent = [&mesh](const Region& r) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : clip(mesh, r).vertices) box.extend(v);
    return box;
  };
  EXPECT_GT(extent(region).min().x(), 0.0);
  EXPECT_GT(extent(region).min().z(), 10.0);
  region.margin = 30.0;
  EXPECT_EQ(extent(region).max().z(), 250.0);
  for (const Vec3& v : clip(mesh, region).vertices) {
    EXPECT_TRUE(v.x() >= 0.0 || v.z() > 170.0) << v.transpose();
  }
}

// Heights count along the direction of the region, whichever way it points.
TEST(Clip, FollowsATiltedDirection) {
  Region region;
  region.direction = Vec3(0.6, 0.0, 0.8);
  region.bottom = 20.0;
  region.top = 30.0;
  const TriangleMesh mesh = ball(), part = clip(mesh, region);
  EXPECT_GT(part.triangles.size(), 0u);
  EXPECT_LT(part.triangles.size(), mesh.triangles.size() / 2);
  for (const Vec3& v : part.vertices) EXPECT_NEAR(v.dot(region.direction), 25.0, 25.0);
}

}  // namespace
}  // namespace toile::body
