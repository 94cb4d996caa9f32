#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "body/import_support.hpp"
#include "body/meshes.hpp"
#include "toile/body/import.hpp"

namespace toile::body {
namespace {

/// Body of flat strips as a CAD program exports it: vertices on its two rims alone, at these places in the plane.
/// `turn`: of the upper rim against the lower one, radians.
TriangleMesh strips(const std::vector<Vec3>& section, double height, double slope = 0.0, double turn = 0.0) {
  TriangleMesh mesh;
  const int n = static_cast<int>(section.size());
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % n);
    mesh.vertices.push_back(section[i]);
    const Vec3 above = Eigen::AngleAxisd(turn, Vec3::UnitZ()) * section[i];
    mesh.vertices.push_back((1.0 + slope * height / section[i].norm()) * above + Vec3(0.0, 0.0, height));
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

/// Places on a circle of 60 mm, every second step round it `ratio` times as wide as the others.
std::vector<Vec3> circle(int segments, double ratio = 1.0) {
  std::vector<Vec3> section;
  double angle = 0.0;
  for (int i = 0; i < segments; ++i) {
    section.emplace_back(60.0 * std::cos(angle), 60.0 * std::sin(angle), 0.0);
    angle += 4.0 * M_PI / segments * (i % 2 == 0 ? 1.0 : ratio) / (1.0 + ratio);
  }
  return section;
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    sum += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
  }
  return sum;
}

void expect_whole(const TriangleMesh& mesh) {
  ImportOptions options;
  options.closed = false;
  EXPECT_EQ(import_body(test::write_obj("cad", mesh), options).notes, "") << "still one surface without gaps";
}

// Triangles as long as the body get vertices all along it, without a gap and on the cylinder that they were cut from,
// however few they are and however unequal in width.
TEST(SplitLongTriangles, PutsVerticesOnTheRoundBody) {
  for (const auto& [segments, ratio] : {std::pair(72, 1.0), {24, 1.0}, {8, 1.0}, {24, 2.0}}) {
    TriangleMesh mesh = strips(circle(segments, ratio), 400.0);
    const std::size_t rims = mesh.vertices.size();
    split_long_triangles(&mesh);
    EXPECT_GT(mesh.vertices.size(), 2 * rims);
    std::vector<double> heights;
    for (const Vec3& v : mesh.vertices) {
      EXPECT_NEAR(std::hypot(v.x(), v.y()), 60.0, 1e-9) << segments;
      if (std::hypot(v.x() - 60.0, v.y()) < 1e-9) heights.push_back(v.z());
    }
    std::sort(heights.begin(), heights.end());
    const double width = 2.0 * 60.0 * std::sin(M_PI / segments);
    for (std::size_t i = 1; i < heights.size(); ++i)
      EXPECT_LT(heights[i] - heights[i - 1], std::max(15.0, 4.0 * width)) << segments;
    expect_whole(mesh);
  }
}

// On a cone they lie on the cone.
TEST(SplitLongTriangles, PutsVerticesOnACone) {
  for (const int segments : {24, 8}) {
    TriangleMesh mesh = strips(circle(segments), 400.0, 0.1);
    const std::size_t rims = mesh.vertices.size();
    split_long_triangles(&mesh);
    EXPECT_GT(mesh.vertices.size(), rims);
    for (const Vec3& v : mesh.vertices) EXPECT_NEAR(std::hypot(v.x(), v.y()), 60.0 + 0.1 * v.z(), 1e-9);
    expect_whole(mesh);
  }
}

// Strips whose rims are turned against each other by half a step have no edge along the body: how far the middles of
// their edges lie inside it is told. Straight ones have none.
TEST(SplitLongTriangles, TellsHowDeepTurnedStripsLie) {
  for (const int segments : {24, 8}) {
    TriangleMesh straight = strips(circle(segments), 400.0, 0.1);
    EXPECT_NEAR(split_long_triangles(&straight), 0.0, 1e-12);
    const double half_step = -M_PI / segments;  // against the diagonals: triangles of equal sides
    TriangleMesh turned = strips(circle(segments), 400.0, 0.0, half_step);
    const double depth = 60.0 * (1.0 - std::cos(0.5 * half_step));
    const double told = split_long_triangles(&turned);
    EXPECT_GT(told, depth) << segments;
    EXPECT_LT(told, 1.5 * depth) << segments;
  }
}

/// The strips closed by fans round a point in the middle of each rim.
TriangleMesh closed_strips(int segments, double height) {
  TriangleMesh mesh = strips(circle(segments), height);
  const int bottom = 2 * segments, top = bottom + 1;
  mesh.vertices.emplace_back(0.0, 0.0, 0.0);
  mesh.vertices.emplace_back(0.0, 0.0, height);
  for (int i = 0; i < segments; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % segments);
    mesh.triangles.push_back({bottom, b, a});
    mesh.triangles.push_back({top, a + 1, b + 1});
  }
  return mesh;
}

// The triangles of caps, which are long as well where strips are many, turn no strip: nothing lies deeper than the
// chords of the rims.
TEST(SplitLongTriangles, CapsTurnNoStrip) {
  for (const int segments : {24, 72}) {
    TriangleMesh mesh = closed_strips(segments, 400.0);
    EXPECT_LT(split_long_triangles(&mesh), 1.1 * 60.0 * (1.0 - std::cos(M_PI / segments))) << segments;
  }
}

// A box stays a box, and the flat sides of one whose edges are rounded stay flat.
TEST(SplitLongTriangles, LeavesFlatSidesFlat) {
  const TriangleMesh box = strips({{60, 50, 0}, {-60, 50, 0}, {-60, -50, 0}, {60, -50, 0}}, 1000.0);
  TriangleMesh mesh = box;
  split_long_triangles(&mesh);
  EXPECT_GT(mesh.triangles.size(), box.triangles.size());
  EXPECT_NEAR(area(mesh) / area(box), 1.0, 1e-12);
  std::vector<Vec3> rounded;  // corners of 10 mm in five steps each
  for (int corner = 0; corner < 4; ++corner)
    for (int i = 0; i <= 5; ++i) {
      const double angle = M_PI_2 * (corner + i / 5.0);
      rounded.emplace_back((corner % 3 == 0 ? 50.0 : -50.0) + 10.0 * std::cos(angle),
                           (corner < 2 ? 40.0 : -40.0) + 10.0 * std::sin(angle), 0.0);
    }
  mesh = strips(rounded, 1000.0);
  split_long_triangles(&mesh);
  for (const Vec3& v : mesh.vertices) {
    EXPECT_LT(std::abs(v.x()), 60.0 + 1e-9);
    EXPECT_LT(std::abs(v.y()), 50.0 + 1e-9);
    if (std::abs(v.x()) < 49.0) {
      EXPECT_NEAR(std::abs(v.y()), 50.0, 1e-9);
    }
  }
  expect_whole(mesh);
}

// A mesh whose triangles are about as wide as long stays as it is.
TEST(SplitLongTriangles, LeavesOthers) {
  TriangleMesh regular = test::random_triangulation(test::elliptic_tube(80.0, 50.0, 160.0), 20.0, 1);
  const std::size_t facets = regular.triangles.size();
  split_long_triangles(&regular);
  EXPECT_EQ(regular.triangles.size(), facets);
}

}  // namespace
}  // namespace toile::body
