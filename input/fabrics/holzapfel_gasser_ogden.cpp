// Fibre-reinforced membrane of Holzapfel, Gasser & Ogden (J. Elasticity 61, 1-48, 2000, eqs. 63-67; dispersion after
// Gasser, Ogden & Holzapfel, J. R. Soc. Interface 3, 15-35, 2006): an incompressible neo-Hookean matrix and two
// families of fibres at the angles +theta and -theta to the wale,
//   W = c/2 (I1 - 3) + k1/(2 k2) sum_i [exp(k2 E_i^2) - 1],   E_i = kappa (I1 - 3) + (1 - 3 kappa) (I_i - 1),
//   I_i = C11 cos^2 theta + C22 sin^2 theta +- 2 C12 sin theta cos theta   (squared stretch of the fibre).
// A family counts only where E_i > 0: fibres carry tension only.
//   toile material build holzapfel_gasser_ogden.cpp
#include "toile/material/plugin.hpp"

using namespace toile::material;

// Media of a rabbit's carotid artery (Holzapfel et al. 2000, table 1), wale along the circumference.
constexpr double carotid_media[] = {3.0e-3, 2.3632e-3, 0.8393, 29.0, 0.0};

struct HolzapfelGasserOgden {
  static constexpr const char* name = "holzapfel-gasser-ogden";
  static constexpr const char* text = "Neo-Hookean matrix with two families of fibres that stiffen exponentially.";
  enum { c, k1, k2, theta, kappa };
  static constexpr std::array<ParamInfo, 5> info = {
      {{"c", "MPa", "Shear modulus of the matrix.", no_default, 0.0, infinity, 1},
       {"k1", "MPa", "Modulus of the fibres.", no_default, 0.0, infinity, 0},
       {"k2", "", "Exponent of the fibres.", no_default, 0.0, 1000.0, 1},
       {"theta", "degree", "Angle between the fibres and the wale.", no_default, 0.0, 90.0, 0},
       {"kappa", "", "Dispersion: 0 all fibres at theta, 1/3 isotropic.", 0.0, 0.0, 1.0 / 3.0, 0}}};
  static constexpr std::array<ParamSet, 1> sets = {
      {{"carotid media", "rabbit carotid artery, media; wale along the circumference", carotid_media}}};

  template <class T, class P>
  static T energy(const PlaneC<T>& C, const Params<P>& p) {
    const P angle = p[theta] * (M_PI / 180.0), cosine = cos(angle), sine = sin(angle);
    const P factor = 0.5 * p[k1] / p[k2], aligned = 1.0 - 3.0 * p[kappa];
    const T I1 = C.C11 + C.C22 + C.C33;
    T W = 0.5 * p[c] * (I1 - 3.0);
    for (const double sign : {1.0, -1.0}) {
      const T I = C.C11 * cosine * cosine + C.C22 * sine * sine + (2.0 * sign) * C.C12 * sine * cosine;
      const T E = p[kappa] * (I1 - 3.0) + aligned * (I - 1.0);
      const T tension = where(less(T(0.0), E), E, T(0.0));
      const T Q = p[k2] * tension * tension;
      W += factor * (exp(Q) - 1.0);
    }
    return W;
  }
};

TOILE_MATERIAL(HolzapfelGasserOgden)
