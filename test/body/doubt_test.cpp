// What a fitted surface says of its own error.
#include <cmath>
#include <iostream>

#include "body/meshes.hpp"
#include "body/surface_checks.hpp"
#include "toile/body/level_set.hpp"

namespace toile::body {
namespace {

/// Root mean squares over a surface of a principal curvature's error, as told and true, over the mean curvature.
struct Doubt {
  double told = 0.0, real = 0.0;
};

/// Noise of so much (mm, root mean square) along the normals.
TriangleMesh noisy(TriangleMesh mesh, double noise) {
  std::mt19937 random(3);
  std::normal_distribution<double> shift(0.0, noise);
  for (Vec3& vertex : mesh.vertices) {
    const double s = noise > 0.0 ? shift(random) : 0.0;
    vertex += s * Vec3(vertex.x(), vertex.y(), 0.0).normalized();
  }
  return mesh;
}

template <class Exact>
Doubt doubt_of(const Surface& surface, double height, const Exact& exact) {
  double told = 0.0, real = 0.0, sum = 0.0;
  int count = 0;
  for (double z = 40.0; z <= height - 40.0; z += 3.1)
    for (double theta = 0.0; theta < 2.0 * M_PI; theta += 0.037) {
      Vec3 point;
      const double wanted = exact(theta, z, &point);
      const SurfacePoint foot = surface.closest(surface.closest(point).closest);
      const Eigen::SelfAdjointEigenSolver<Mat3> solver(foot.hessian);
      const Vec3 direction = solver.eigenvectors().col(2);
      real += std::pow(solver.eigenvalues()[2] - wanted, 2);
      told += std::pow(direction.dot(surface.doubt(foot.closest).hessian * direction), 2);
      sum += wanted;
      ++count;
    }
  return {std::sqrt(told / count) / (sum / count), std::sqrt(real / count) / (sum / count)};
}

double ellipse_curvature(double t, double z, Vec3* point) {
  constexpr double a = 80.0, b = 50.0;
  *point = {a * std::cos(t), b * std::sin(t), z};
  return a * b / std::pow(std::hypot(a * std::sin(t), b * std::cos(t)), 3);
}

Doubt doubt_of(double edge, double noise, bool lobed) {
  const test::TubeShape shape = lobed ? test::lobed_tube(200.0) : test::elliptic_tube(80.0, 50.0, 200.0);
  const auto surface = level_set(noisy(test::random_triangulation(shape, edge, 1), noise), {}, "tube");
  const Doubt doubt =
      lobed ? doubt_of(*surface, 200.0, test::lobed_curvature) : doubt_of(*surface, 200.0, ellipse_curvature);
  std::cout << "edge " << edge << " noise " << noise << (lobed ? " lobed" : " ellipse") << ": told " << doubt.told
            << " real " << doubt.real << " ratio " << doubt.told / doubt.real << "\n";
  return doubt;
}

// The told error of the curvature of a noisy scan is the true one in the mean square, within a half, be it 0.8 % or 60
// %.
TEST(Doubt, IsTheErrorByScanNoise) {
  for (const double edge : {5.0, 20.0})
    for (const double noise : {0.05, 0.5}) {
      const Doubt doubt = doubt_of(edge, noise, false);
      EXPECT_GT(doubt.told, 0.7 * doubt.real) << edge << " " << noise;
      EXPECT_LT(doubt.told, 1.5 * doubt.real) << edge << " " << noise;
    }
}

// Waves of 75 mm that coarse facets flatten by 6 % are told with up to 2.5 times of that.
TEST(Doubt, HoldsWhatSmoothingFlattens) {
  for (const double noise : {0.0, 0.2}) {
    const Doubt doubt = doubt_of(20.0, noise, true);
    EXPECT_GT(doubt.told, doubt.real) << noise;
    EXPECT_LT(doubt.told, 2.5 * doubt.real) << noise;
  }
}

// Of exact vertices next to nothing is doubtful, as next to nothing is wrong.
TEST(Doubt, IsSmallOfExactVertices) {
  for (const bool lobed : {false, true}) {
    const Doubt doubt = doubt_of(10.0, 0.0, lobed);
    EXPECT_GT(doubt.told, 0.4 * doubt.real);
    EXPECT_LT(doubt.told, 2.0 * doubt.real);
    EXPECT_LT(doubt.told, 0.02);
  }
}

}  // namespace
}  // namespace toile::body
