#include "verification/ring.hpp"

#include <cmath>
#include <complex>

namespace toile::test {
namespace {

using body::Vec3;

double girth(const std::vector<Vec3>& ring) {
  double sum = 0.0;
  for (size_t i = 0; i < ring.size(); ++i) sum += (ring[(i + 1) % ring.size()] - ring[i]).norm();
  return sum;
}

}  // namespace

std::vector<double> turning(const body::Surface& surface, std::vector<Vec3> ring) {
  std::vector<Vec3> normals;
  for (Vec3& x : ring) {
    const body::SurfacePoint p = surface.closest(x);
    x = p.closest;
    normals.push_back(p.normal);
  }
  std::vector<double> result;
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec3 before = ring[i] - ring[(i + n - 1) % n], after = ring[(i + 1) % n] - ring[i];
    const Vec3 force = before.normalized() - after.normalized();
    result.push_back(force.dot(normals[i]) / (0.5 * (before.norm() + after.norm())));
  }
  return result;
}

std::vector<double> short_waves(const std::vector<Vec3>& ring, const std::vector<double>& values, double wavelength) {
  const size_t n = values.size();
  const double waves = girth(ring) / wavelength;
  std::vector<double> noise = values;
  for (size_t k = 0; static_cast<double>(k) <= waves && 2 * k < n; ++k) {
    const auto wave = [&](size_t i) {
      return std::polar(1.0, 2.0 * M_PI * static_cast<double>(k * i) / static_cast<double>(n));
    };
    std::complex<double> c = 0.0;
    for (size_t i = 0; i < n; ++i) c += values[i] * std::conj(wave(i)) / static_cast<double>(n);
    for (size_t i = 0; i < n; ++i) noise[i] -= (k == 0 ? 1.0 : 2.0) * (c * wave(i)).real();
  }
  const auto half = static_cast<size_t>(static_cast<double>(n) / waves);
  for (size_t i = 0; i < n; ++i) {
    double mean = 0.0;
    for (size_t m = 0; m <= 2 * half; ++m) mean += values[(i + n - half + m) % n] / static_cast<double>(2 * half + 1);
    noise[i] /= mean;
  }
  return noise;
}

}  // namespace toile::test
