#pragma once

#include "toile/material/law.hpp"

// Rebar model of a knitted fabric (doc/theory.md, "Materials"):
//   W = C10 (tr C - 3) + psi_wale(e(C11)) + psi_course(e(C22)),   C11, C22: squared stretch of each fibre.
// Fibre strain e of the squared stretch q:   log: ln(q)/2   engineering: sqrt(q) - 1   green: (q - 1)/2.
// Fibre stress s = dpsi/de (Kirchhoff, nominal or second Piola-Kirchhoff, whichever is conjugate to e), with the
// modulus E(e) = sum_i c_i e^i read as
//   tangent: s = integral of E  = sum c_i e^(i+1)/(i+1),   psi = sum c_i e^(i+2)/((i+1)(i+2))
//   secant:  s = E(e) e         = sum c_i e^(i+1),         psi = sum c_i e^(i+2)/(i+2).
// Beyond the calibrated strain L: s = s(L) + s'(L) (e - L), so psi = psi(L) + s(L) (e - L) + s'(L) (e - L)^2/2.
// Below zero strain: nothing (fibres carry no compression), or the same continuation at L = 0: psi = c_0 e^2/2.

namespace toile::material::rebar {

inline constexpr int terms = 6;

enum { C10, wale, course = wale + terms, strain = course + terms, modulus, compression, calibrated, n_params };
enum { log_strain, engineering_strain, green_strain };
enum { tangent, secant };
enum { compression_off, compression_on };

inline constexpr ParamInfo coefficient(const char* name, const char* text, double fallback = 0.0) {
  return {name, "MPa", text, fallback, -infinity, infinity, 0};
}
inline constexpr ParamInfo choice(const char* name, const char* text, const char* words, int count) {
  return {name, "", text, 0.0, 0.0, count - 1.0, 0, words};
}

inline constexpr double pantyhose[n_params] = {8.4667e-3, 0.0001,     0.1672,  -2.225,          21.199, -62.05,
                                               61.746,    0.0032,     -0.075,  0.4653,          -1.340, 1.9400,
                                               -0.986,    log_strain, tangent, compression_off, 1.0};
inline constexpr double t_shirt[n_params] = {3.82e-2, 0.0064,     0.0786,  -0.287,          0.2156, 0.0,
                                             0.0,     -0.010,     0.0206,  0.0291,          -0.013, 0.0,
                                             0.0,     log_strain, tangent, compression_off, 1.0};

/// Energy and its first two derivatives of one fibre, from the coefficients: psi = sum_k a_k e^(k+2).
template <class P>
struct FibreLaw {
  std::array<P, terms> a;

  FibreLaw(const Params<P>& p, int first) {
    const bool is_secant = p.choice(modulus) == secant;
    for (int k = 0; k < terms; ++k) a[k] = p[first + k] * (1.0 / ((is_secant ? 1.0 : k + 1.0) * (k + 2.0)));
  }
  template <class T>
  T energy(const T& e) const {
    T sum = a[terms - 1];
    for (int k = terms - 2; k >= 0; --k) sum = sum * e + a[k];
    return sum * e * e;
  }
  P stress(const P& e) const {
    P sum = a[terms - 1] * (terms + 1.0);
    for (int k = terms - 2; k >= 0; --k) sum = sum * e + a[k] * (k + 2.0);
    return sum * e;
  }
  P slope(const P& e) const {
    P sum = a[terms - 1] * ((terms + 1.0) * terms);
    for (int k = terms - 2; k >= 0; --k) sum = sum * e + a[k] * ((k + 2.0) * (k + 1.0));
    return sum;
  }
};

template <class T>
T fibre_strain(const T& stretch_squared, int kind) {
  if (kind == log_strain) return 0.5 * log(stretch_squared);
  if (kind == green_strain) return 0.5 * (stretch_squared - 1.0);
  return sqrt(stretch_squared) - 1.0;
}

/// Energy of one fibre family; `first`: its coefficient of order 0.
template <class T, class U, class P>
U fibre_energy(const PlaneC<T>& c, const U& stretch_squared, const Params<P>& p, int first) {
  const FibreLaw<P> law(p, first);
  const P end = p[calibrated];
  const U e = fibre_strain(stretch_squared, p.choice(strain));
  const U beyond = e - end;
  const auto is_beyond = less(U(end), e);
  const auto is_compressed = less(e, U(0.0));
  const U continued = law.energy(end) + beyond * (law.stress(end) + beyond * (0.5 * law.slope(end)));
  const U in_tension = where(is_beyond, continued, law.energy(e));
  c.extrapolated_where(is_beyond);
  if (p.choice(compression) == compression_off) return where(is_compressed, U(0.0), in_tension);
  c.extrapolated_where(is_compressed);
  return where(is_compressed, U(e * e * law.a[0]), in_tension);
}

struct Law {
  static constexpr const char* name = "rebar";
  static constexpr const char* text =
      "Incompressible matrix with fibres along wale and course whose modulus is a polynomial of the fibre strain e: "
      "E_wale = sum c_i e^i, E_course = sum d_i e^i.";
  static constexpr std::array<ParamInfo, n_params> info = {
      {{"C10", "MPa", "Half the shear modulus of the matrix.", no_default, 0.0, infinity, 1},
       coefficient("c0", "Coefficient of e^0 in the wale modulus.", no_default),
       coefficient("c1", "Coefficient of e^1 in the wale modulus."),
       coefficient("c2", "Coefficient of e^2 in the wale modulus."),
       coefficient("c3", "Coefficient of e^3 in the wale modulus."),
       coefficient("c4", "Coefficient of e^4 in the wale modulus."),
       coefficient("c5", "Coefficient of e^5 in the wale modulus."),
       coefficient("d0", "Coefficient of e^0 in the course modulus.", no_default),
       coefficient("d1", "Coefficient of e^1 in the course modulus."),
       coefficient("d2", "Coefficient of e^2 in the course modulus."),
       coefficient("d3", "Coefficient of e^3 in the course modulus."),
       coefficient("d4", "Coefficient of e^4 in the course modulus."),
       coefficient("d5", "Coefficient of e^5 in the course modulus."),
       choice("strain", "Fibre strain e of the fibre's stretch l: ln l, l - 1 or (l^2 - 1)/2.", "log|engineering|green",
              3),
       choice("modulus",
              "Whether E is the slope of the fibre's stress-strain curve (tangent) or stress over strain (secant).",
              "tangent|secant", 2),
       choice(
           "fibres in compression",
           "off: a shortened fibre carries nothing; on: its stress continues linearly with its modulus at zero strain.",
           "off|on", 2),
       {"calibrated strain", "", "End of the calibrated range of e; beyond it the fibre stress continues linearly.",
        1.0, 0.0, infinity, 1}}};
  static constexpr std::array<ParamSet, 2> sets = {
      {{"pantyhose", "published fit to tensile tests of a pantyhose fabric", pantyhose},
       {"t-shirt", "published fit to tensile tests of a T-shirt fabric", t_shirt}}};

  template <class T, class P>
  static T energy(const PlaneC<T>& c, const Params<P>& p) {
    const T matrix = p[C10] * (c.C11 + c.C22 + c.C33 - 3.0);
    const T fibres = along<P>(c.C11, [&](const auto& q) { return fibre_energy(c, q, p, wale); }) +
                     along<P>(c.C22, [&](const auto& q) { return fibre_energy(c, q, p, course); });
    return matrix + fibres;
  }
};

}  // namespace toile::material::rebar
