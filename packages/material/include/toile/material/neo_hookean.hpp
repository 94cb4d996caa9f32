#pragma once

#include "toile/material/law.hpp"

namespace toile::material::neo_hookean {

inline constexpr double pantyhose[] = {8.4667e-3};
inline constexpr double t_shirt[] = {3.82e-2};

struct Law {
  static constexpr const char* name = "neo-hookean";
  static constexpr const char* text = "Isotropic incompressible matrix: W = C10 (tr C - 3).";
  enum { C10 };
  static constexpr std::array<ParamInfo, 1> info = {
      {{"C10", "MPa", "Half the shear modulus.", no_default, 0.0, infinity, 1}}};
  static constexpr std::array<ParamSet, 2> sets = {
      {{"pantyhose", "matrix of the pantyhose fabric's rebar model, without its fibres", pantyhose},
       {"t-shirt", "matrix of the T-shirt fabric's rebar model, without its fibres", t_shirt}}};

  template <class T, class P>
  static T energy(const PlaneC<T>& c, const Params<P>& p) {
    return p[C10] * (c.C11 + c.C22 + c.C33 - 3.0);
  }
};

}  // namespace toile::material::neo_hookean
