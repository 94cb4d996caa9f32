#pragma once

#include "toile/material/law.hpp"

// Isotropic elasticity that is linear in the principal logarithmic strains e1, e2 (Hencky, Z. techn. Phys. 9 (1928)
// 215-220), in plane stress:
//   W = Y/(2 (1 - nu^2)) (e1^2 + e2^2 + 2 nu e1 e2) = Y/4 [(e1 + e2)^2/(1 - nu) + (e1 - e2)^2/(1 + nu)],
// with e1 + e2 = ln(det C)/2 and |e1 - e2| = atanh(sqrt(q)), q = (difference over sum of the eigenvalues of C)^2, and
// e3 = -nu/(1 - nu) (e1 + e2) through the thickness: incompressible for nu = 1/2.

namespace toile::material::hencky {

/// atanh(sqrt(q))^2, 0 <= q < 1: smooth, as a function of q, also where the stretches are equal. The series of
/// atanh(s)/s in q = s^2 below `join` (its first neglected term is 1e-20 of the sum there, 1e-17 in the second
/// derivative); the closed form, whose second derivative loses digits as 1/q, above.
template <class U>
U squared_atanh_of_root(const U& q) {
  constexpr double join = 0.1;
  constexpr int terms = 19;
  U ratio = 1.0 / (2.0 * terms - 1.0);
  for (int k = terms - 2; k >= 0; --k) {
    const U next = ratio * q + 1.0 / (2.0 * k + 1.0);
    ratio = next;
  }
  const U series = q * ratio * ratio;
  const U root = sqrt(q);
  const U quotient = (1.0 + root) / (1.0 - root);
  const U difference = 0.5 * log(quotient);
  const U closed = difference * difference;
  return where(less(q, U(join)), series, closed);
}

struct Law {
  static constexpr const char* name = "hencky";
  static constexpr const char* text = "Isotropic, linear in the logarithmic strain (Hencky) and compressible.";
  enum { young, poisson };
  static constexpr std::array<ParamInfo, 2> info = {
      {{"Young's modulus", "MPa", "Kirchhoff stress over logarithmic strain of a pulled strip.", no_default, 0.0,
        infinity, 1},
       {"Poisson's ratio", "", "Lateral over axial logarithmic strain of a pulled strip, its sign turned.", no_default,
        -1.0, 0.5, 1}}};

  template <class T, class P>
  static T energy(const PlaneC<T>& c, const Params<P>& p) {
    const T difference = c.C11 - c.C22, trace = c.C11 + c.C22;
    const T inverse = reciprocal(trace);
    const T q = (difference * difference + 4.0 * c.C12 * c.C12) * inverse * inverse;
    const T twice_sum = log(c.det);
    const T apart = along<P>(q, [](const auto& u) { return squared_atanh_of_root(u); });
    const P quarter = 0.25 * p[young];
    const P of_sum = 0.25 * quarter / (1.0 - p[poisson]), of_difference = quarter / (1.0 + p[poisson]);
    return of_sum * twice_sum * twice_sum + of_difference * apart;
  }

  template <class T, class P>
  static T thickness_stretch(const PlaneC<T>& c, const Params<P>& p) {
    const P exponent = -0.5 * p[poisson] / (1.0 - p[poisson]);
    return power(c.det, exponent);
  }
};

}  // namespace toile::material::hencky
