#include "toile/run/shadow.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace toile::test {
namespace {

using solve::Vec3;

/// A ring of quadrilaterals round the z axis between two radii, mm, at a height that does not matter.
struct Ring {
  mesh::Mesh mesh;
  std::vector<Vec3> position;

  Ring(double inner, double outer, int around) {
    mesh.blocks.emplace_back();
    for (int k = 0; k < around; ++k) {
      const double angle = 2.0 * M_PI * k / around;
      for (const double radius : {inner, outer})
        position.emplace_back(radius * std::cos(angle), radius * std::sin(angle), radius - 7.0 * (k % 2));
      const int next = (k + 1) % around;
      for (const int node : {2 * k, 2 * k + 1, 2 * next + 1, 2 * next}) mesh.blocks[0].connectivity.push_back(node);
    }
  }
  run::Shadow shadow(double disc, const Vec3& point = Vec3::Zero(), const Vec3& direction = Vec3::UnitZ()) const {
    return run::shadow(mesh, position, point, direction, disc);
  }
};

double polygon(double radius, int corners) {
  return 0.5 * corners * radius * radius * std::sin(2.0 * M_PI / corners);
}

double circle(double radius) {
  return M_PI * radius * radius;
}

// A ring that begins on the disc casts the shadow of the polygon round it; fabric that lies over fabric counts once.
TEST(Shadow, IsThatOfTheWholeFabric) {
  Ring ring(90.0, 150.0, 48);
  EXPECT_NEAR(ring.shadow(90.0).area, polygon(150.0, 48), 1e-4 * circle(150.0));
  const size_t nodes = ring.position.size();
  for (size_t n = 0; n < nodes; ++n) ring.position.push_back(ring.position[n] + Vec3(0.0, 0.0, 20.0));
  const std::vector<int> below = ring.mesh.blocks[0].connectivity;
  for (const int node : below) ring.mesh.blocks[0].connectivity.push_back(node + static_cast<int>(nodes));
  EXPECT_NEAR(ring.shadow(90.0).area, polygon(150.0, 48), 1e-4 * circle(150.0));
}

// Light that falls between disc and fabric is not shadow; a shadow within the disc's adds nothing.
TEST(Shadow, LeavesOutWhatIsLit) {
  const double lit = polygon(110.0, 48) - circle(90.0);
  EXPECT_NEAR(Ring(110.0, 150.0, 48).shadow(90.0).area, polygon(150.0, 48) - lit, 1e-4 * circle(150.0));
  EXPECT_NEAR(Ring(40.0, 80.0, 48).shadow(90.0).area, circle(90.0), 1e-9 * circle(90.0));
}

// The outline is the edge of the fabric, or of the disc where no fabric goes beyond it.
TEST(Shadow, HasTheOutlineOfTheFabric) {
  const run::Shadow hexagon = Ring(90.0, 150.0, 6).shadow(90.0);
  const size_t directions = hexagon.outline.size();
  EXPECT_NEAR(hexagon.outline[0], 150.0, 1e-9);
  EXPECT_NEAR(hexagon.outline[directions / 12], 150.0 * std::cos(M_PI / 6.0), 1e-9);
  for (const double radius : Ring(40.0, 80.0, 6).shadow(90.0).outline) EXPECT_EQ(radius, 90.0);
}

// Along an axis that is turned and moved with the fabric, the shadow is the same.
TEST(Shadow, FallsAlongTheAxis) {
  Ring ring(90.0, 150.0, 7);
  const double area = ring.shadow(90.0).area;
  const Eigen::AngleAxisd turn(1.1, Vec3(1.0, 2.0, -0.5).normalized());
  const Vec3 moved(10.0, -20.0, 30.0);
  for (Vec3& x : ring.position) x = turn * x + moved;
  EXPECT_NEAR(ring.shadow(90.0, moved, turn * Vec3(0.0, 0.0, 3.0)).area, area, 1e-4 * area);
}

std::vector<double> waves(int folds, double amplitude, int ripples, double ripple) {
  std::vector<double> outline;
  for (int k = 0; k < 1440; ++k) {
    const double angle = 2.0 * M_PI * k / 1440;
    outline.push_back(120.0 + amplitude * std::cos(folds * angle) + ripple * std::cos(ripples * angle + 0.7));
  }
  return outline;
}

// Every wave of the outline is a fold, wherever the outline begins; ripples that are lower than a fold are none.
TEST(Folds, AreTheWavesOfTheOutline) {
  for (const int folds : {1, 4, 7}) EXPECT_EQ(run::count_folds(waves(folds, 10.0, 41, 0.4), 1.2), folds);
  EXPECT_EQ(run::count_folds(waves(5, 0.5, 41, 0.0), 1.2), 0);
  EXPECT_EQ(run::count_folds(std::vector<double>(1440, 150.0), 1.2), 0);
}

}  // namespace
}  // namespace toile::test
