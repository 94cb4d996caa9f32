#pragma once

#include "toile/material/law.hpp"

// Polyconvex orthotropic model of Itskov (doc/theory.md, "Materials"):
//   W = 1/4 sum_r mu_r [ (J_r^alpha_r - 1)/alpha_r + (K_r^beta_r - 1)/beta_r ],
//   J_r = tr(C M_r), K_r = tr(cof(C) M_r), M_r = sum_i w_i^(r) n_i (x) n_i, w_3 = 1 - w_1 - w_2.
// n_1 is the wale; det C = 1. Normalised weights are divided by their sum where w_1 + w_2 > 1 (then w_3 = 0); elsewhere
// w_3 makes the sum one as it is.

namespace toile::material::itskov {

enum { mu, alpha, beta, w1, w2, per_term };
enum { normalise = 3 * per_term, swap_axes, n_params };

inline constexpr double pantyhose[n_params] = {1.2755e-2, 4.727, 1.003, 0.771, 0.229,  //
                                               2.0569e-3, 1.475, 16.16, 0.585, 0.415,  //
                                               4.5867e-2, 1.736, 1.063, 0.652, 0.348, 0, 0};
inline constexpr std::array<double, n_params> t_shirt_set(bool normalised) {
  return {6.8837e-3, 3.52, 1.004, 0.321, 0.565,  //
          8.6240e-2, 1.28, 13.49, 0.585, 0.435,  //
          1.2354e-1, 1.00, 1.002, 0.781, 0.219, normalised ? 1.0 : 0.0, 0};
}
inline constexpr std::array<double, n_params> t_shirt = t_shirt_set(true);
inline constexpr std::array<double, n_params> t_shirt_as_printed = t_shirt_set(false);

inline constexpr ParamInfo modulus(const char* name) {
  return {name, "MPa", "Modulus mu_r of term r (the name's last digit).", no_default, 0.0, infinity, 1};
}
inline constexpr ParamInfo exponent(const char* name, const char* text) {
  return {name, "", text, no_default, 1.0, infinity, 0};
}
inline constexpr ParamInfo weight(const char* name, const char* text) {
  return {name, "", text, no_default, 0.0, 1.0, 0};
}
inline constexpr const char* j_text = "Exponent alpha_r of J_r = tr(C M_r).";
inline constexpr const char* k_text = "Exponent beta_r of K_r = tr(cof(C) M_r).";
inline constexpr const char* w1_text = "Weight of the wale in M_r.";
inline constexpr const char* w2_text = "Weight of the course in M_r; that of the thickness is w_3 = 1 - w_1 - w_2.";

struct Law {
  static constexpr const char* name = "itskov";
  static constexpr const char* text =
      "Polyconvex orthotropic incompressible model with three terms: "
      "W = 1/4 sum_r mu_r [(J_r^alpha_r - 1)/alpha_r + (K_r^beta_r - 1)/beta_r].";
  static constexpr std::array<ParamInfo, n_params> info = {
      {modulus("mu1"),
       exponent("alpha1", j_text),
       exponent("beta1", k_text),
       weight("w1_1", w1_text),
       weight("w2_1", w2_text),
       modulus("mu2"),
       exponent("alpha2", j_text),
       exponent("beta2", k_text),
       weight("w1_2", w1_text),
       weight("w2_2", w2_text),
       modulus("mu3"),
       exponent("alpha3", j_text),
       exponent("beta3", k_text),
       weight("w1_3", w1_text),
       weight("w2_3", w2_text),
       {"normalise weights", "", "true: the weights of a term are divided by their sum where w_1 + w_2 > 1.", 0.0, 0.0,
        1.0, 0, "false|true"},
       {"swap axes", "", "true: the weights w_1 are the course's and w_2 the wale's.", 0.0, 0.0, 1.0, 0,
        "false|true"}}};
  static constexpr std::array<ParamSet, 3> sets = {
      {{"pantyhose", "published fit to tensile tests of a pantyhose fabric", pantyhose},
       {"t-shirt",
        "published fit to tensile tests of a T-shirt fabric, with normalised weights (as printed, those of term 2 "
        "add up to 1.02)",
        t_shirt.data()},
       {"t-shirt as printed", "the same with its weights as printed: refused, because w_3 = -0.02 in term 2",
        t_shirt_as_printed.data()}}};

  static int check(const double* params, char* message, int length) {
    if (params[normalise] != 0.0) return 0;
    for (int r = 0; r < 3; ++r) {
      const double* term = params + r * per_term;
      const double w3 = 1.0 - term[w1] - term[w2];
      if (w3 >= -1e-12) continue;  // weights that add up to one may miss it by rounding
      std::snprintf(
          message, length,
          "the weights of term %d add up to %.6g, so w_3 = 1 - w_1 - w_2 = %.6g is negative: J can turn "
          "negative and the energy is not polyconvex; set \"normalise weights\" to true to divide the weights "
          "by their sum",
          r + 1, term[w1] + term[w2], w3);
      return r * per_term + w2 + 1;
    }
    return 0;
  }

  template <class T, class P>
  static T energy(const PlaneC<T>& c, const Params<P>& p) {
    const T cof11 = c.cof11(), cof22 = c.cof22(), cof33 = c.cof33();
    const bool swapped = p.choice(swap_axes) != 0;
    T sum = 0.0;
    for (int r = 0; r < 3; ++r) {
      const int term = r * per_term;
      P wale = p[term + (swapped ? w2 : w1)];
      P course = p[term + (swapped ? w1 : w2)];
      if (p.choice(normalise) != 0) {
        const P total = wale + course;
        const P divisor = where(less(P(1.0), total), total, P(1.0));
        wale /= divisor;
        course /= divisor;
      }
      const P thickness = 1.0 - wale - course;
      const T J = wale * c.C11 + course * c.C22 + thickness * c.C33;
      const T K = wale * cof11 + course * cof22 + thickness * cof33;
      const P over_alpha = 0.25 * p[term + mu] / p[term + alpha];
      const P over_beta = 0.25 * p[term + mu] / p[term + beta];
      sum += over_alpha * (power(J, p[term + alpha]) - 1.0) + over_beta * (power(K, p[term + beta]) - 1.0);
    }
    return sum;
  }
};

}  // namespace toile::material::itskov
