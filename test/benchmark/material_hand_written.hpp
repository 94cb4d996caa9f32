#pragma once

#include <array>
#include <cmath>

/// Stress and tangent as one would write them by hand, one point at a time: what the registered materials are compared
/// with. Parameters in the order of the registered material.
namespace toile::benchmarks {

struct Point {
  double W;
  std::array<double, 3> S;
  std::array<double, 6> D;  ///< 11, 22, 33, 12, 13, 23
};

/// g = (a, b, c) and its outer product, as derivatives by E = (C11/2, C22/2, C12).
inline void add(Point& p, double slope, double curvature, const std::array<double, 3>& g) {
  for (int a = 0; a < 3; ++a) p.S[a] += slope * g[a];
  p.D[0] += curvature * g[0] * g[0];
  p.D[1] += curvature * g[1] * g[1];
  p.D[2] += curvature * g[2] * g[2];
  p.D[3] += curvature * g[0] * g[1];
  p.D[4] += curvature * g[0] * g[2];
  p.D[5] += curvature * g[1] * g[2];
}

/// det of the in-plane C and its derivatives by E: d2 = (0, 0, -2, 4, 0, 0).
struct Determinant {
  double value, C33;
  std::array<double, 3> gradient;
  Determinant(double c11, double c22, double c12)
      : value(c11 * c22 - c12 * c12), C33(1.0 / value), gradient{2.0 * c22, 2.0 * c11, -2.0 * c12} {}
};

/// Adds factor * C33.
inline void add_C33(Point& p, double factor, const Determinant& det) {
  const double first = -factor * det.C33 * det.C33;
  add(p, first, -2.0 * first * det.C33, det.gradient);
  p.D[2] += -2.0 * first;
  p.D[3] += 4.0 * first;
}

inline Point neo_hookean(double c11, double c22, double c12, const double* params) {
  const Determinant det(c11, c22, c12);
  const double C10 = params[0];
  Point p = {C10 * (c11 + c22 + det.C33 - 3.0), {2.0 * C10, 2.0 * C10, 0.0}, {}};
  add_C33(p, C10, det);
  return p;
}

inline void add_fibre(Point& p, double q, int axis, const double* c) {
  const double e = 0.5 * std::log(q);
  if (e < 0.0) return;
  const double x = e < 1.0 ? e : 1.0;
  double psi = 0.0, stress = 0.0, modulus = 0.0;
  for (int i = 5; i >= 0; --i) {
    psi = psi * x + c[i] * (1.0 / ((i + 1.0) * (i + 2.0)));
    stress = stress * x + c[i] * (1.0 / (i + 1.0));
    modulus = modulus * x + c[i];
  }
  psi *= x * x;
  stress *= x;
  p.W += psi + (e - x) * (stress + 0.5 * modulus * (e - x));
  stress += modulus * (e - x);
  p.S[axis] += stress / q;
  p.D[axis] += (modulus - 2.0 * stress) / (q * q);
}

inline Point rebar(double c11, double c22, double c12, const double* params) {
  Point p = neo_hookean(c11, c22, c12, params);
  add_fibre(p, c11, 0, params + 1);
  add_fibre(p, c22, 1, params + 7);
  return p;
}

/// Adds mu/4 (x^a - 1)/a for a trace x with derivatives g, and the second derivatives that x itself has.
inline double add_power(Point& p, double mu, double a, double x, const std::array<double, 3>& g) {
  const double y = std::pow(x, a - 2.0);
  p.W += 0.25 * mu * (y * x * x - 1.0) / a;
  const double slope = 0.25 * mu * y * x;
  add(p, slope, 0.25 * mu * (a - 1.0) * y, g);
  return slope;
}

inline Point itskov(double c11, double c22, double c12, const double* params) {
  const Determinant det(c11, c22, c12);
  const double C33 = det.C33, minus_square = -C33 * C33;
  const auto& dd = det.gradient;
  const std::array<double, 3> d33 = {minus_square * dd[0], minus_square * dd[1], minus_square * dd[2]};
  Point p = {};
  for (int r = 0; r < 3; ++r, params += 5) {
    const double mu = params[0], w1 = params[3], w2 = params[4], w3 = 1.0 - w1 - w2;
    const double slope_J = add_power(p, mu, params[1], w1 * c11 + w2 * c22 + w3 * C33,
                                     {2.0 * w1 + w3 * d33[0], 2.0 * w2 + w3 * d33[1], w3 * d33[2]});
    const double m = w1 * c22 + w2 * c11;  // K = m C33 + w3 det
    const double slope_K = add_power(
        p, mu, params[2], m * C33 + w3 * det.value,
        {2.0 * w2 * C33 + m * d33[0] + w3 * dd[0], 2.0 * w1 * C33 + m * d33[1] + w3 * dd[1], m * d33[2] + w3 * dd[2]});
    const double by_C33 = slope_J * w3 + slope_K * m, by_det = slope_K * w3;
    const double outer = 2.0 * by_C33 * C33 * C33 * C33, curved = by_C33 * minus_square + by_det;
    add(p, 0.0, outer, dd);
    p.D[2] += -2.0 * curved;
    p.D[3] += 4.0 * curved + slope_K * 2.0 * (w2 * d33[1] + w1 * d33[0]);
    p.D[0] += slope_K * 4.0 * w2 * d33[0];
    p.D[1] += slope_K * 4.0 * w1 * d33[1];
    p.D[4] += slope_K * 2.0 * w2 * d33[2];
    p.D[5] += slope_K * 2.0 * w1 * d33[2];
  }
  return p;
}

inline Point isotropic_elastic(double c11, double c22, double c12, const double* params) {
  const double nu = params[1], modulus = 0.5 * params[0] / (1.0 - nu * nu), shear = (1.0 - nu) * modulus;
  const double E11 = 0.5 * (c11 - 1.0), E22 = 0.5 * (c22 - 1.0), E12 = 0.5 * c12, sum = E11 + E22;
  return {modulus * sum * sum + 2.0 * shear * (E12 * E12 - E11 * E22),
          {2.0 * (modulus * sum - shear * E22), 2.0 * (modulus * sum - shear * E11), 2.0 * shear * E12},
          {2.0 * modulus, 2.0 * modulus, shear, 2.0 * (modulus - shear), 0.0, 0.0}};
}

/// atanh(sqrt(q))^2 and its first two derivatives; near q = 0, where the closed form cancels, by the series of
/// atanh(s)/s.
inline std::array<double, 3> squared_atanh_of_root(double q) {
  if (q < 0.1) {
    double r = 0.0, slope = 0.0, half_curvature = 0.0;
    for (int k = 18; k >= 0; --k) {
      half_curvature = half_curvature * q + slope;
      slope = slope * q + r;
      r = r * q + 1.0 / (2.0 * k + 1.0);
    }
    const double square = r * r, square_slope = 2.0 * r * slope;
    return {q * square, square + q * square_slope,
            2.0 * square_slope + q * (2.0 * slope * slope + 4.0 * r * half_curvature)};
  }
  const double s = std::sqrt(q), A = 0.5 * std::log((1.0 + s) / (1.0 - s)), rest = 1.0 - q;
  return {A * A, A / (s * rest), 0.5 * (1.0 - A * (1.0 - 3.0 * q) / s) / (q * rest * rest)};
}

inline Point hencky(double c11, double c22, double c12, const double* params) {
  const Determinant det(c11, c22, c12);
  const double nu = params[1], quarter = 0.25 * params[0];
  const double of_sum = 0.25 * quarter / (1.0 - nu), of_difference = quarter / (1.0 + nu);
  const double over_trace = 1.0 / (c11 + c22), difference = c11 - c22;
  const double square = difference * difference + 4.0 * c12 * c12;
  const double twice_sum = std::log(det.value), by_trace = over_trace * over_trace, q = square * by_trace;
  const std::array<double, 3> f = squared_atanh_of_root(q);

  Point p = {of_sum * twice_sum * twice_sum + of_difference * f[0], {}, {}};
  const double by_det = 2.0 * of_sum * twice_sum * det.C33;
  add(p, by_det, (2.0 * of_sum - 2.0 * of_sum * twice_sum) * det.C33 * det.C33, det.gradient);
  p.D[2] -= 2.0 * by_det;
  p.D[3] += 4.0 * by_det;

  const std::array<double, 3> of_square = {4.0 * difference, -4.0 * difference, 8.0 * c12};
  const double trace_slope = -4.0 * q * over_trace;
  add(p, of_difference * f[1], of_difference * f[2],
      {of_square[0] * by_trace + trace_slope, of_square[1] * by_trace + trace_slope, of_square[2] * by_trace});
  const double factor = of_difference * f[1] * by_trace, mixed = -4.0 * factor * over_trace, twice = 24.0 * factor * q;
  p.D[0] += 8.0 * factor + 2.0 * mixed * of_square[0] + twice;
  p.D[1] += 8.0 * factor + 2.0 * mixed * of_square[1] + twice;
  p.D[2] += 8.0 * factor;
  p.D[3] += -8.0 * factor + mixed * (of_square[0] + of_square[1]) + twice;
  p.D[4] += mixed * of_square[2];
  p.D[5] += mixed * of_square[2];
  return p;
}

}  // namespace toile::benchmarks
