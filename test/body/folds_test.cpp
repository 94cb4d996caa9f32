// Where a body bends sharply: the smooth surface keeps to the vertices there.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "body/surface_checks.hpp"
#include "toile/body/import.hpp"
#include "toile/body/level_set.hpp"

namespace toile::body {
namespace {

/// Largest distance to the vertices within `radius` of a place or of its mirror image, mm; all vertices are found.
double error_near(const Surface& surface, const TriangleMesh& mesh, const Vec3& place, double radius) {
  double largest = 0.0;
  for (const Vec3& v : mesh.vertices) {
    if (std::min((v - place).norm(), (v - Vec3(-place.x(), place.y(), place.z())).norm()) > radius) continue;
    const SurfacePoint p = surface.closest(v);
    EXPECT_TRUE(p.found) << v.transpose();
    largest = std::max(largest, std::abs(p.gap));
  }
  return largest;
}

// On the whole real body, in cells of 12 mm, the smooth surface is within 2 mm of the scan in armpit and crotch. Tips
// that are smaller than a cell stay rounded (nipples by 5 mm), so that fabric does not press on what its mesh does not
// see.
TEST(Folds, RealBody) {
  const TriangleMesh mesh = import_body(TOILE_SOURCE_DIR "/input/bodies/female_body.obj", {}).mesh;
  const SurfacePtr surface = level_set(mesh, {}, "whole body");
  const double armpit = error_near(*surface, mesh, {152.0, -13.0, 1199.0}, 60.0);
  const double crotch = error_near(*surface, mesh, {0.0, -31.0, 743.0}, 60.0);
  const double nipple = error_near(*surface, mesh, {91.0, -152.0, 1159.0}, 30.0);
  double squares = 0.0, areas = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    const SurfacePoint p = surface->closest(a);
    if (!p.found) continue;  // in the mouth
    squares += area * p.gap * p.gap;
    areas += area;
  }
  const double rms = std::sqrt(squares / areas);
  std::cout << "  " << surface->summary() << "\n  armpit " << armpit << " crotch " << crotch << " nipple " << nipple
            << " rms " << rms << " mm\n";
  EXPECT_LT(armpit, 2.0);
  EXPECT_LT(crotch, 2.0);
  EXPECT_LT(nipple, 6.0);
  EXPECT_LT(rms, 0.8);
}

}  // namespace
}  // namespace toile::body
