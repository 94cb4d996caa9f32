#include "director.hpp"

#include <cmath>

namespace toile::element {
namespace {

/// sin(a)/a as a function of s = a^2, with its derivatives by s, and cos(a).
struct Sinc {
  double cosine, f, f1, f2;
};

/// Taylor series: the closed forms lose all digits of f1 and f2 for small angles. Below one radian the first neglected
/// term is below 1e-20.
Sinc series(double s) {
  constexpr int terms = 12;
  double coefficient[terms] = {1.0};
  for (int k = 1; k < terms; ++k) coefficient[k] = -coefficient[k - 1] / ((2.0 * k) * (2.0 * k + 1.0));
  double f = 0.0, f1 = 0.0, f2 = 0.0;
  for (int k = terms - 1; k >= 0; --k) {
    f2 = f2 * s + 2.0 * f1;
    f1 = f1 * s + f;
    f = f * s + coefficient[k];
  }
  return {f + 2.0 * s * f1, f, f1, f2};
}

Sinc closed(double s) {
  const double angle = std::sqrt(s), cosine = std::cos(angle), f = std::sin(angle) / angle;
  const double f1 = (cosine - f) / (2.0 * s);
  return {cosine, f, f1, (-0.5 * f - 3.0 * f1) / (2.0 * s)};
}

}  // namespace

// With t = w_1 t_1 + w_2 t_2: d = cos d_n + f t, and d cos/ds = -f/2.
Director director(const double* frame, const double* w) {
  const double s = w[0] * w[0] + w[1] * w[1];
  const Sinc e = s < 1.0 ? series(s) : closed(s);
  Director out;
  for (int c = 0; c < 3; ++c) {
    const double t1 = frame[c], t2 = frame[3 + c], normal = frame[6 + c];
    const double t = w[0] * t1 + w[1] * t2;
    out.d[c] = e.cosine * normal + e.f * t;
    const double radial = 2.0 * e.f1 * t - e.f * normal;
    out.first[0][c] = radial * w[0] + e.f * t1;
    out.first[1][c] = radial * w[1] + e.f * t2;
    const double curved = 4.0 * e.f2 * t - 2.0 * e.f1 * normal;
    out.second[0][c] = curved * w[0] * w[0] + radial + 4.0 * e.f1 * w[0] * t1;
    out.second[1][c] = curved * w[1] * w[1] + radial + 4.0 * e.f1 * w[1] * t2;
    out.second[2][c] = curved * w[0] * w[1] + 2.0 * e.f1 * (w[0] * t2 + w[1] * t1);
  }
  return out;
}

}  // namespace toile::element
