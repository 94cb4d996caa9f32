#include <Eigen/Geometry>
#include <cmath>

#include "body/surface_checks.hpp"
#include "toile/body/import.hpp"
#include "toile/body/level_set.hpp"

namespace toile::body {
namespace {

class RealBody : public testing::Test {
 protected:
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
  /// The trunk from the hips to the chest, without arms.
  TriangleMesh trunk() const {
    Region region;
    region.lower.z() = 830.0;
    region.upper.z() = 1140.0;
    region.seed = Vec3(0.0, -100.0, 1000.0);
    return clip(import_body(file_, {}).mesh, region);
  }
  const std::string file_ = TOILE_SOURCE_DIR "/input/bodies/female_body.obj";
};

/// Curvature along the horizontal section at height z, at equal angles around `centre`; each entry is found.
/// `length` (may be null): of the section, mm.
std::vector<double> section_curvature(const Surface& surface, const Vec3& centre, int samples,
                                      double* length = nullptr) {
  std::vector<double> curvature;
  std::vector<Vec3> points;
  for (int i = 0; i < samples; ++i) {
    const double angle = 2.0 * M_PI * i / samples;
    const Vec3 ray(std::cos(angle), std::sin(angle), 0.0);
    double inside = 0.0, outside = 200.0;
    while (outside - inside > 1e-9) {
      const double middle = 0.5 * (inside + outside);
      (surface.closest(centre + middle * ray).gap < 0.0 ? inside : outside) = middle;
    }
    const SurfacePoint p = surface.closest(centre + inside * ray);
    EXPECT_TRUE(p.found);
    const Vec3 tangent = Vec3::UnitZ().cross(p.normal).normalized();
    curvature.push_back(tangent.dot(p.hessian * tangent));
    points.push_back(p.closest);
  }
  if (length != nullptr) {
    *length = 0.0;
    for (int i = 0; i < samples; ++i) *length += (points[(i + 1) % samples] - points[i]).norm();
  }
  return curvature;
}

/// The part of a periodic signal with `first_mode` periods or more.
std::vector<double> high_pass(const std::vector<double>& signal, int first_mode) {
  const double n = static_cast<double>(signal.size());
  std::vector<double> rest = signal;
  for (int mode = 0; mode < first_mode; ++mode) {
    double c = 0.0, s = 0.0;
    for (std::size_t i = 0; i < signal.size(); ++i) {
      c += signal[i] * std::cos(2.0 * M_PI * mode * i / n) * (mode == 0 ? 1.0 : 2.0) / n;
      s += signal[i] * std::sin(2.0 * M_PI * mode * i / n) * 2.0 / n;
    }
    for (std::size_t i = 0; i < signal.size(); ++i) {
      rest[i] -= c * std::cos(2.0 * M_PI * mode * i / n) + s * std::sin(2.0 * M_PI * mode * i / n);
    }
  }
  return rest;
}

// The real body loads without any repair; its intersecting facets are reported.
TEST_F(RealBody, Loads) {
  const Import import = import_body(file_, {});
  EXPECT_EQ(import.mesh.vertices.size(), 13380u);
  EXPECT_EQ(import.mesh.triangles.size(), 2u * 13378u);
  EXPECT_EQ(import.notes, "warning: 20 pairs of facets intersect");
}

// The region around one leg holds that leg only.
TEST_F(RealBody, OneLegOnly) {
  for (const Vec3& v : leg().vertices) {
    EXPECT_GT(v.x(), 0.0);
  }
}

// Up to just below the crotch, with a margin that takes in a part of the hip, the other leg is left out.
TEST_F(RealBody, MarginLeavesTheOtherLegOut) {
  Region region;
  region.bottom = 100.0;
  region.top = 740.0;
  region.seed = Vec3(145.0, -25.0, 420.0);
  region.margin = 50.0;
  const TriangleMesh part = clip(import_body(file_, {}).mesh, region);
  EXPECT_LT(part.triangles.size(), 2000u);
  double top = 0.0;
  for (const Vec3& v : part.vertices) {
    EXPECT_TRUE(v.x() > 0.0 || v.z() > 700.0) << v.transpose();
    top = std::max(top, v.z());
  }
  EXPECT_GT(top, 780.0);
}

// On the thigh, where edges are 27 mm long on average, the curvature of the smooth surface with the cell and smoothing
// chosen from the mesh has less than 10 % noise of that wavelength anywhere, and the surface stays within 3 mm of the
// vertices.
TEST_F(RealBody, ThighIsSmooth) {
  const TriangleMesh mesh = leg();
  const SurfacePtr surface = level_set(mesh, {}, "leg");
  std::cout << "  " << surface->summary() << "\n";
  for (double z = 500.0; z <= 680.0; z += 20.0) {
    Vec3 centre = Vec3::Zero();
    int count = 0;
    for (const Vec3& v : mesh.vertices) {
      if (std::abs(v.z() - z) < 20.0) {
        centre += v;
        ++count;
      }
    }
    centre /= count;
    centre.z() = z;
    const auto curvature = section_curvature(*surface, centre, 720);
    double mean = 0.0;
    for (const double k : curvature) mean += k / 720.0;
    const int mode = static_cast<int>(std::floor(2.0 * M_PI / mean / 27.0));  // wavelengths up to 27 mm
    double largest = 0.0, squares = 0.0;
    for (const double k : high_pass(curvature, mode)) {
      largest = std::max(largest, std::abs(k) / mean);
      squares += k * k / (mean * mean) / 720.0;
    }
    std::cout << "  z " << z << ": curvature noise max " << largest << " rms " << std::sqrt(squares) << "\n";
    EXPECT_LT(largest, 0.1);
  }
  for (const Vec3& v : mesh.vertices) {
    EXPECT_LT(std::abs(surface->closest(v).gap), 3.0);
  }
}

// From the hips to the chest, where a frictionless fabric's pressure is its tension times this curvature, the noise of
// wavelengths below 20 mm is less than 3 % of the mean curvature, root mean square. Where the section is hollow (the
// groove of the spine, sharper than 20 mm at its lower end) the fabric bridges it and has no pressure.
TEST_F(RealBody, TrunkIsSmooth) {
  const SurfacePtr surface = level_set(trunk(), {}, "trunk");
  std::cout << "  " << surface->summary() << "\n";
  for (double z = 880.0; z <= 1100.0; z += 20.0) {
    double length = 0.0;
    const auto curvature = section_curvature(*surface, Vec3(0.0, -60.0, z), 720, &length);
    double mean = 0.0, squares = 0.0;
    for (const double k : curvature) mean += k / 720.0;
    const auto noise = high_pass(curvature, static_cast<int>(length / 20.0));
    for (int i = 0; i < 720; ++i) squares += curvature[i] > 0.0 ? noise[i] * noise[i] / 720.0 : 0.0;
    std::cout << "  z " << z << ": curvature noise rms " << std::sqrt(squares) / mean << "\n";
    EXPECT_LT(std::sqrt(squares) / mean, 0.03) << z;
  }
}

}  // namespace
}  // namespace toile::body
