#include "toile/body/level_set.hpp"

#include <cmath>

#include "body/meshes.hpp"
#include "body/surface_checks.hpp"

namespace toile::body {
namespace {

SurfacePtr fitted(const test::TubeShape& shape, double edge, unsigned seed) {
  return level_set(test::random_triangulation(shape, edge, seed), {}, "tube");
}

/// Errors of the larger principal curvature, relative to its mean over the surface.
struct CurvatureError {
  double largest = 0.0;
  double root_mean_square = 0.0;
};

/// Sampled away from the open ends. `exact(u, z, &point)`: curvature there.
template <class Exact>
CurvatureError curvature_error(const Surface& surface, double height, const Exact& exact) {
  CurvatureError error;
  double squares = 0.0, sum = 0.0;
  int count = 0;
  for (double z = 40.0; z <= height - 40.0; z += 3.1) {
    for (double theta = 0.0; theta < 2.0 * M_PI; theta += 0.037) {
      Vec3 point;
      const double wanted = exact(theta, z, &point);
      const double difference = std::abs(test::largest_curvature(surface, point) - wanted);
      error.largest = std::max(error.largest, difference);
      squares += difference * difference;
      sum += wanted;
      ++count;
    }
  }
  error.root_mean_square = std::sqrt(squares / count) / (sum / count);
  error.largest /= sum / count;
  return error;
}

double ellipse_curvature(double t, double z, Vec3* point) {
  constexpr double a = 80.0, b = 50.0;
  *point = {a * std::cos(t), b * std::sin(t), z};
  return a * b / std::pow(std::hypot(a * std::sin(t), b * std::cos(t)), 3);
}

// Normals and Hessians of the fitted surface are the derivatives of its gap, on both sides, across cells and facets.
TEST(LevelSet, DerivativesMatchFiniteDifferences) {
  const auto surface = fitted(test::lobed_tube(160.0), 5.0, 1);
  const auto errors = test::derivative_errors(*surface, 300, -5.0, 20.0, 1e-3, [](std::mt19937& random) -> Vec3 {
    std::uniform_real_distribution<double> z(30.0, 130.0), angle(0.0, 2.0 * M_PI);
    const double t = angle(random);
    return {61.0 * std::cos(t), 61.0 * std::sin(t), z(random)};
  });
  EXPECT_LT(errors.normal, 1e-6);
  EXPECT_LT(errors.hessian, 3e-4);
  EXPECT_GT(errors.largest_hessian, 1e-2);
  EXPECT_GT(errors.inside, 30);
  EXPECT_GT(errors.outside, 100);
}

// From an unstructured triangulation with 5 mm edges the curvature of the elliptic cylinder comes back within 1 %.
TEST(LevelSet, CurvatureOfEllipticCylinder) {
  for (const unsigned seed : {1u, 2u}) {
    const auto surface = fitted(test::elliptic_tube(80.0, 50.0, 160.0), 5.0, seed);
    const CurvatureError error = curvature_error(*surface, 160.0, ellipse_curvature);
    std::cout << surface->summary() << "\n  curvature error max " << error.largest << " rms " << error.root_mean_square
              << "\n";
    EXPECT_LT(error.largest, 0.01);
    EXPECT_LT(error.root_mean_square, 0.004);
  }
}

// The same for the lobed body, whose shape is not in the null space of the smoothing: within a few per cent.
TEST(LevelSet, CurvatureOfLobedBody) {
  const auto surface = fitted(test::lobed_tube(160.0), 5.0, 1);
  const CurvatureError error = curvature_error(*surface, 160.0, test::lobed_curvature);
  std::cout << surface->summary() << "\n  curvature error max " << error.largest << " rms " << error.root_mean_square
            << "\n";
  EXPECT_LT(error.largest, 0.03);
  EXPECT_LT(error.root_mean_square, 0.006);
}

// Halving the edges of the lobed body with its cell reduces the error of the curvature at second order or better.
TEST(LevelSet, CurvatureConverges) {
  const auto shape = test::lobed_tube(160.0);
  const auto coarse = level_set(test::random_triangulation(shape, 8.0, 1), {11.2, 1e-3}, "coarse");
  const auto fine = level_set(test::random_triangulation(shape, 4.0, 1), {5.6, 1e-3}, "fine");
  const double before = curvature_error(*coarse, 160.0, test::lobed_curvature).root_mean_square;
  const double after = curvature_error(*fine, 160.0, test::lobed_curvature).root_mean_square;
  std::cout << "  rms curvature error " << before << " -> " << after << "\n";
  EXPECT_GT(std::log2(before / after), 0.95 * 2.0);
}

// The fitted surface stays close to the vertices that it was made from, and its offset contact points are found.
TEST(LevelSet, LiesOnItsVertices) {
  const auto mesh = test::random_triangulation(test::lobed_tube(160.0), 5.0, 2);
  const auto surface = level_set(mesh, {}, "tube");
  for (const Vec3& vertex : mesh.vertices) {
    const SurfacePoint p = surface->closest(vertex);
    ASSERT_TRUE(p.found);
    EXPECT_LT(std::abs(p.gap), 0.05);
    EXPECT_TRUE(surface->closest(vertex + 5.0 * p.normal).found);
    EXPECT_TRUE(surface->closest(vertex - 5.0 * p.normal).found);
  }
}

// Out of reach, inside and outside, the answer is "not found" with the signed distance to the facets, so that a search
// along a ray can step by it.
TEST(LevelSet, FarPointsHaveTheDistanceToTheFacets) {
  const auto surface = fitted(test::elliptic_tube(80.0, 50.0, 160.0), 5.0, 1);
  const SurfacePoint inside = surface->closest({5.0, 0.0, 80.0}), outside = surface->closest({0.0, 150.0, 80.0});
  EXPECT_FALSE(inside.found);
  EXPECT_FALSE(outside.found);
  const double exact = elliptic_cylinder(80.0, 50.0, {0.0, 1.0})->closest({5.0, 0.0, 0.0}).gap;
  EXPECT_NEAR(inside.gap, exact, 0.2);
  EXPECT_NEAR(outside.gap, 100.0, 0.2);
}

// Bare facets, offered for comparison only, have the facet's distance and no curvature.
TEST(Facets, HaveNoCurvature) {
  const auto surface =
      facet_surface(test::random_triangulation(test::elliptic_tube(80.0, 50.0, 100.0), 5.0, 1), "bare");
  const SurfacePoint p = surface->closest({0.0, 53.0, 50.0});
  EXPECT_TRUE(p.found);
  EXPECT_NEAR(p.gap, 3.0, 0.1);
  EXPECT_EQ(p.hessian.norm(), 0.0);
}

}  // namespace
}  // namespace toile::body
