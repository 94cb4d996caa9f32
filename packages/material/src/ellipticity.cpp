#include "toile/material/ellipticity.hpp"

#include <algorithm>
#include <cmath>

namespace toile::material {
namespace {

/// a + b cos(phi) + c sin(phi), phi = 2 theta, of the angle theta of n: what a quadratic form in n is.
struct Harmonic {
  double a, b, c;
  double at(double cosine, double sine) const { return a + b * cosine + c * sine; }
};

/// t11 n1^2 + t22 n2^2 + 2 t12 n1 n2.
Harmonic quadratic_form(double t11, double t22, double t12) {
  return {0.5 * (t11 + t22), 0.5 * (t11 - t22), t12};
}

/// sum of w[k] terms[k].
Harmonic combination(const std::array<double, 3>& w, const std::array<Harmonic, 3>& terms) {
  Harmonic sum = {0.0, 0.0, 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    sum.a += w[k] * terms[k].a;
    sum.b += w[k] * terms[k].b;
    sum.c += w[k] * terms[k].c;
  }
  return sum;
}

/// The acoustic tensor turned back by the rotation of F: Q = (n.S.n) 1 + U M U, with U^2 = C and
/// M_cd = n_a D_ca,db n_b, from P = F S(C).
class AcousticTensor {
 public:
  AcousticTensor(const std::array<double, 3>& C, const std::array<double, 3>& S, const std::array<double, 6>& D) {
    const auto [D11, D22, D33, D12, D13, D23] = D;
    const std::array<Harmonic, 3> M = {quadratic_form(D11, D33, D13), quadratic_form(D33, D22, D23),
                                       quadratic_form(D13, D23, 0.5 * (D12 + D33))};
    // Square root of a 2 x 2 tensor: (C + sqrt(det C) 1) / sqrt(tr C + 2 sqrt(det C)).
    const double root = std::sqrt(C[0] * C[1] - C[2] * C[2]), scale = 1.0 / std::sqrt(C[0] + C[1] + 2.0 * root);
    const double u = scale * (C[0] + root), v = scale * (C[1] + root), w = scale * C[2];
    const Harmonic stress = quadratic_form(S[0], S[1], S[2]);
    const Harmonic Q11 = combination({u * u, w * w, 2.0 * u * w}, M), Q22 = combination({w * w, v * v, 2.0 * v * w}, M);
    mean_ = combination({0.5, 0.5, 1.0}, {Q11, Q22, stress});
    half_difference_ = combination({0.5, -0.5, 0.0}, {Q11, Q22, stress});
    off_diagonal_ = combination({u * w, v * w, u * v + w * w}, M);
  }

  double mean(double cosine, double sine) const { return mean_.at(cosine, sine); }
  /// Half the difference of the eigenvalues.
  double spread(double cosine, double sine) const {
    const double d = half_difference_.at(cosine, sine), q = off_diagonal_.at(cosine, sine);
    return std::sqrt(d * d + q * q);
  }
  double smaller(double phi) const {
    const double cosine = std::cos(phi), sine = std::sin(phi);
    return mean(cosine, sine) - spread(cosine, sine);
  }

 private:
  Harmonic mean_, half_difference_, off_diagonal_;
};

const double pi = std::acos(-1.0);

/// Directions of the scan: the square of an eigenvalue's distance from the mean has four periods at most.
constexpr std::size_t directions = 64;

struct Table {
  std::array<double, directions> cosine, sine;
  Table() {
    for (std::size_t k = 0; k < directions; ++k) {
      cosine[k] = std::cos(2.0 * pi * static_cast<double>(k) / directions);
      sine[k] = std::sin(2.0 * pi * static_cast<double>(k) / directions);
    }
  }
};

/// Minimum of the smaller eigenvalue in [low, high] by golden sections.
double polished(const AcousticTensor& Q, double low, double high) {
  constexpr double part = 0.6180339887498949, accuracy = 1e-8;
  double left = high - part * (high - low), right = low + part * (high - low);
  double at_left = Q.smaller(left), at_right = Q.smaller(right);
  while (high - low > accuracy) {
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - part * (high - low);
      at_left = Q.smaller(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + part * (high - low);
      at_right = Q.smaller(right);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

Ellipticity ellipticity(const std::array<double, 3>& C, const std::array<double, 3>& S,
                        const std::array<double, 6>& D) {
  static const Table table;
  const AcousticTensor Q(C, S, D);
  std::array<double, directions> smaller, larger;
  for (std::size_t k = 0; k < directions; ++k) {
    const double mean = Q.mean(table.cosine[k], table.sine[k]), spread = Q.spread(table.cosine[k], table.sine[k]);
    smaller[k] = mean - spread;
    larger[k] = mean + spread;
  }
  Ellipticity result = {smaller[0], *std::max_element(larger.begin(), larger.end()), {1.0, 0.0}};
  for (std::size_t k = 0; k < directions; ++k) {
    if (smaller[k] > smaller[(k + 1) % directions] || smaller[k] > smaller[(k + directions - 1) % directions]) continue;
    const double width = 2.0 * pi / directions, middle = width * static_cast<double>(k);
    const double phi = polished(Q, middle - width, middle + width), value = Q.smaller(phi);
    if (value >= result.smallest) continue;
    result.smallest = value;
    result.direction = {std::cos(0.5 * phi), std::sin(0.5 * phi)};
  }
  return result;
}

// With a = F^T m, m.Q.m = (n.S.n) |m|^2 + e.D.e with the strain e = (a1 n1, a2 n2, a1 n2 + a2 n1).
bool is_surely_elliptic(const std::array<double, 3>& S, const std::array<double, 6>& D) {
  if (!(S[0] >= 0.0 && S[1] >= 0.0 && S[0] * S[1] >= S[2] * S[2])) return false;
  const auto [D11, D22, D33, D12, D13, D23] = D;
  if (!(D11 > 0.0)) return false;
  const double second = D22 - D12 * D12 / D11, across = D23 - D12 * D13 / D11;
  return second > 0.0 && D33 - D13 * D13 / D11 - across * across / second > 0.0;
}

}  // namespace toile::material
