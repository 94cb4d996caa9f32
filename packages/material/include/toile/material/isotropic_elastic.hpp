#pragma once

#include "toile/material/law.hpp"

// Isotropic linear elasticity at finite rotation (Saint Venant-Kirchhoff) in plane stress, Green strain E = (C - I)/2:
//   W = Y/(2 (1 - nu^2)) [E11^2 + E22^2 + 2 nu E11 E22 + 2 (1 - nu) E12^2],   E33 = -nu/(1 - nu) (E11 + E22).
// It is not incompressible: h/h0 = sqrt(1 + 2 E33), bounded below by `stretch_floor`.

namespace toile::material::isotropic_elastic {

struct Law {
  static constexpr const char* name = "isotropic-elastic";
  static constexpr const char* text =
      "Isotropic, linear in the Green strain (Saint Venant-Kirchhoff) and compressible: for small strains.";
  enum { young, poisson };
  static constexpr std::array<ParamInfo, 2> info = {
      {{"Young's modulus", "MPa", "Stress over strain of a slightly stretched strip.", no_default, 0.0, infinity, 1},
       {"Poisson's ratio", "", "Lateral contraction over extension of that strip.", no_default, -1.0, 0.5, 1}}};

  template <class T, class P>
  static T energy(const PlaneC<T>& c, const Params<P>& p) {
    const P nu = p[poisson];
    const P modulus = 0.5 * p[young] / (1.0 - nu * nu);
    const T E11 = 0.5 * (c.C11 - 1.0), E22 = 0.5 * (c.C22 - 1.0), E12 = 0.5 * c.C12;
    const T sum = E11 + E22;
    return modulus * (sum * sum + 2.0 * (1.0 - nu) * (E12 * E12 - E11 * E22));
  }

  template <class T, class P>
  static T thickness_stretch(const PlaneC<T>& c, const Params<P>& p) {
    const T squared = 1.0 - p[poisson] / (1.0 - p[poisson]) * (c.C11 + c.C22 - 2.0);
    const double floor = stretch_floor * stretch_floor;
    return sqrt(where(less(squared, T(floor)), T(floor), squared));
  }
};

}  // namespace toile::material::isotropic_elastic
