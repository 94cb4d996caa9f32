#include "toile/result/shown_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "support.hpp"

namespace toile::result::test {
namespace {

constexpr double radius = 60.0, scan_radius = 60.3;  // mm

/// A cylinder about z.
class Cylinder final : public body::Surface {
 public:
  body::SurfacePoint closest(const body::Vec3& point) const override {
    body::SurfacePoint found;
    const body::Vec3 across(point.x(), point.y(), 0.0);
    found.gap = across.norm() - radius;
    found.normal = across.normalized();
    found.closest = point - found.gap * found.normal;
    found.found = true;
    return found;
  }
  double range() const override { return 30.0; }
  body::TriangleMesh triangles(double) const override { return {}; }
  std::string summary() const override { return "cylinder"; }
};

/// Triangles of 25 to 35 mm of a tube of this radius, 400 mm high.
body::TriangleMesh scan(double of_radius) {
  return revolution([of_radius](double) { return of_radius; }, 0.0, 400.0, 12, 21);
}

/// A sleeve with elements of 5 mm, from height 20 to 80, on the body.
mesh::Mesh sleeve() {
  return tube([](double) { return 60.5; }, 20.0, 60.0, 72, 12);
}

double height_of(const body::TriangleMesh& mesh, const std::array<int, 3>& t) {
  double sum = 0.0;
  for (const int v : t) sum += mesh.vertices[static_cast<std::size_t>(v)].z() / 3.0;
  return sum;
}

// Under a garment the body is shown by triangles of the size of its elements that lie on the smooth surface, without
// gaps; away from it by its own. What the surface misses of the scan is told for all of them.
TEST(ShownBody, IsFineUnderTheGarment) {
  const ShownBody shown = shown_body(Cylinder(), scan(scan_radius), sleeve(), std::nullopt);
  std::map<std::pair<int, int>, int> sides;
  double longest = 0.0, area = 0.0;
  for (const auto& t : shown.mesh.triangles) {
    const auto vertex = [&](std::size_t k) { return shown.mesh.vertices[static_cast<std::size_t>(t[k % 3])]; };
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[std::minmax(t[k], t[(k + 1) % 3])];
      if (height_of(shown.mesh, t) < 110.0) longest = std::max(longest, (vertex(k) - vertex(k + 1)).norm());
    }
    if (height_of(shown.mesh, t) < 100.0) area += 0.5 * (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).norm();
  }
  EXPECT_LT(longest, 1.5 * 5.3);
  EXPECT_NEAR(area, 2.0 * M_PI * radius * 100.0, 0.02 * area);
  for (const auto& [side, count] : sides) {
    const double z = shown.mesh.vertices[static_cast<std::size_t>(side.first)].z();
    const bool at_end = std::abs(z) < 1e-9 || std::abs(z - 400.0) < 1e-9;
    EXPECT_TRUE(count == 2 || (count == 1 && at_end)) << count << " triangles at height " << z;
  }
  for (const body::Vec3& vertex : shown.mesh.vertices) {
    const double at = std::hypot(vertex.x(), vertex.y());
    if (vertex.z() < 115.0) {
      EXPECT_NEAR(at, radius, 1e-9) << vertex.z();
    }
    if (vertex.z() > 180.0) {
      EXPECT_NEAR(at, scan_radius, 1e-9) << vertex.z();
    }
  }
  ASSERT_EQ(shown.error.size(), shown.mesh.vertices.size());
  for (const double error : shown.error) EXPECT_NEAR(error, radius - scan_radius, 1e-9);
}

// Triangles that were made from the surface stay; a garment that starts away from the body makes all of it fine; a
// given size holds.
TEST(ShownBody, IsDividedAsFarAsItMatters) {
  EXPECT_EQ(shown_body(Cylinder(), scan(radius), sleeve(), std::nullopt).mesh.triangles.size(),
            scan(radius).triangles.size());
  mesh::Mesh away = sleeve();
  for (mesh::Vec3& node : away.placed) node.y() -= 500.0;
  const auto lowest = [](const ShownBody& shown) {
    return std::all_of(shown.mesh.vertices.begin(), shown.mesh.vertices.end(), [](const body::Vec3& vertex) {
      return std::abs(std::hypot(vertex.x(), vertex.y()) - radius) < 1e-9;
    });
  };
  EXPECT_TRUE(lowest(shown_body(Cylinder(), scan(scan_radius), away, std::nullopt)));
  const std::size_t fine = shown_body(Cylinder(), scan(scan_radius), sleeve(), 5.0).mesh.triangles.size();
  const std::size_t coarse = shown_body(Cylinder(), scan(scan_radius), sleeve(), 10.0).mesh.triangles.size();
  EXPECT_GT(fine, 2 * coarse);
  EXPECT_EQ(shown_body(Cylinder(), scan(scan_radius), sleeve(), 100.0).mesh.triangles.size(),
            scan(scan_radius).triangles.size());
}

}  // namespace
}  // namespace toile::result::test
