// Fung-type orthotropic exponential membrane (Fung, Fronek & Patitucci, Am. J. Physiol. 237, H620-H631, 1979, with the
// shear term of Tong & Fung, J. Biomech. 9, 649-657, 1976):
//   W = c/2 (exp(Q) - 1),   Q = A1 E11^2 + A2 E22^2 + 2 A3 E11 E22 + A4 E12^2,   E = (C - 1)/2,
// hence S11 = c exp(Q) (A1 E11 + A3 E22), S22 = c exp(Q) (A3 E11 + A2 E22), S12 = c/2 exp(Q) A4 E12.
// Q is positive, and W convex in E, if A1 A2 > A3^2.
//   toile material build fung_orthotropic.cpp
#include "toile/material/plugin.hpp"

using namespace toile::material;

struct FungOrthotropic {
  static constexpr const char* name = "fung-orthotropic";
  static constexpr const char* text = "Fung-type orthotropic exponential in the Green strains: W = c/2 (exp(Q) - 1).";
  enum { c, A1, A2, A3, A4 };
  static constexpr std::array<ParamInfo, 5> info = {
      {{"c", "MPa", "Modulus c.", no_default, 0.0, infinity, 1},
       {"A1", "", "Factor of E11^2 (wale).", no_default, 0.0, 1000.0, 1},
       {"A2", "", "Factor of E22^2 (course).", no_default, 0.0, 1000.0, 1},
       {"A3", "", "Half the factor of E11 E22; A3^2 < A1 A2.", no_default, -1000.0, 1000.0, 0},
       {"A4", "", "Factor of E12^2 (shear).", no_default, 0.0, 1000.0, 1}}};

  static int check(const double* p, char* message, int length) {
    if (p[A3] * p[A3] < p[A1] * p[A2]) return 0;
    std::snprintf(message, length, "A3^2 = %.6g must be less than A1 A2 = %.6g, or Q is not positive", p[A3] * p[A3],
                  p[A1] * p[A2]);
    return A3 + 1;
  }

  template <class T, class P>
  static T energy(const PlaneC<T>& C, const Params<P>& p) {
    const T E11 = 0.5 * (C.C11 - 1.0), E22 = 0.5 * (C.C22 - 1.0), E12 = 0.5 * C.C12;
    const T Q = p[A1] * E11 * E11 + p[A2] * E22 * E22 + 2.0 * p[A3] * E11 * E22 + p[A4] * E12 * E12;
    return 0.5 * p[c] * (exp(Q) - 1.0);
  }
};

TOILE_MATERIAL(FungOrthotropic)
