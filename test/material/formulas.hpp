#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "toile/material/formula.hpp"

// Built-in laws as typed formulas, with the parameters of the built-in ones.
namespace toile::material::test {

inline const std::string neo_hookean_formula = "C10*(I1 - 3)";

/// The reading that is the default: logarithmic strain, tangent modulus, no fibre force in compression; 0 <= e <= 1.
inline const std::string rebar_formula =
    "e = max(ln(l1), 0); f = max(ln(l2), 0); C10*(I1 - 3)"
    " + e^2*(c0/2 + e*(c1/6 + e*(c2/12 + e*(c3/20 + e*(c4/30 + e*c5/42)))))"
    " + f^2*(d0/2 + f*(d1/6 + f*(d2/12 + f*(d3/20 + f*(d4/30 + f*d5/42)))))";

inline std::string itskov_formula() {
  std::string text = "K11 = C22*C33; K22 = C11*C33; K33 = C11*C22 - C12^2; ", sum;
  for (const char r : {'1', '2', '3'}) {
    std::string term =
        "mu#/4*(((w1_#*C11 + w2_#*C22 + (1 - w1_# - w2_#)*C33)^alpha# - 1)/alpha#"
        " + ((w1_#*K11 + w2_#*K22 + (1 - w1_# - w2_#)*K33)^beta# - 1)/beta#)";
    std::replace(term.begin(), term.end(), '#', r);
    sum += (sum.empty() ? "" : " + ") + term;
  }
  return text + sum;
}

/// The formula with the first `count` parameters of the built-in law `like`, so that its values serve both.
inline Laws::Law formula_like(const char* like, int count, const std::string& energy) {
  const LawV1& law = *find(like);
  std::vector<FormulaParameter> parameters;
  for (int k = 0; k < count; ++k)
    parameters.push_back({law.info[k].name, law.info[k].unit, law.info[k].text, law.info[k].fallback, law.info[k].lower,
                          law.info[k].upper});
  return make_formula_law(std::string(like) + " as a formula", "", energy, std::move(parameters));
}

}  // namespace toile::material::test
