#pragma once

#include <array>

namespace toile::mesh {

/// Integral of f over [from, to] by the four-point Gauss rule (exact for polynomials up to degree 7).
template <class F>
double gauss_integral(const F& f, double from, double to) {
  constexpr std::array<double, 2> at{0.3399810435848563, 0.8611363115940526};
  constexpr std::array<double, 2> weight{0.6521451548625461, 0.3478548451374538};
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  double sum = 0.0;
  for (int k = 0; k < 2; ++k) sum += weight[k] * (f(middle - half * at[k]) + f(middle + half * at[k]));
  return half * sum;
}

}  // namespace toile::mesh
