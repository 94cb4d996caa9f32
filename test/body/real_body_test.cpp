#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>

#include "body/surface_checks.hpp"
#include "toile/body/import.hpp"
#include "toile/body/level_set.hpp"
#include "toile/body/triangle_tree.hpp"

namespace toile::body {
namespace {

class RealBody : public testing::Test {
 protected:
  void SetUp() override {
    file_ = std::filesystem::path(TOILE_SOURCE_DIR) / ".." / "shared" / "bodies" / "female_body.obj";
    if (!std::filesystem::exists(file_)) {
      GTEST_SKIP() << "the real body is not part of the project; this test needs ../shared/bodies/female_body.obj";
    }
  }
  /// The left leg below the crotch.
  TriangleMesh leg() const {
    Region region;
    region.lower.z() = 90.0;
    region.upper.z() = 720.0;
    const TriangleMesh whole = import_body(file_, {}).mesh;
    for (const Vec3& v : whole.vertices) {
      if (v.x() > 0.0 && std::abs(v.z() - 400.0) < 10.0 && v.x() < 200.0) {
        region.seed = v;
      }
    }
    return clip(whole, region);
  }
  std::string file_;
};

// The real body loads without any repair; its intersecting facets are reported.
TEST_F(RealBody, Loads) {
  const Import import = import_body(file_, {});
  EXPECT_EQ(import.mesh.vertices.size(), 13380u);
  EXPECT_EQ(import.mesh.triangles.size(), 2u * 13378u);
  std::cout << "  notes: " << import.notes << "\n";
}

// The region around one leg holds that leg only.
TEST_F(RealBody, OneLegOnly) {
  for (const Vec3& v : leg().vertices) {
    EXPECT_GT(v.x(), 0.0);
  }
}

}  // namespace
}  // namespace toile::body
