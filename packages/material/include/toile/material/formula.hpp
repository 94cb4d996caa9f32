#pragma once

#include <string>
#include <vector>

#include "toile/material/material.hpp"

namespace toile::material {

/// A parameter of a typed energy.
struct FormulaParameter {
  std::string name;
  std::string unit, text;
  double fallback;  ///< default value; NaN: required
  double lower, upper;
};

/// A law from its energy per reference volume (MPa) as text, differentiated as a compiled one: `energy` may name C11,
/// C22, C12, C33, I1, I2, J, l1, l2, E11, E22, E12 and the parameters, begin with definitions "name = ...;", and use
/// + - * / ^, ln, exp, sqrt, sin, cos, min, max and if(a < b, then, else). Throws InputError with the place of the
/// mistake (a line with the formula, a line with a caret), or of a parameter's name that is taken.
Laws::Law make_formula_law(const std::string& name, const std::string& text, const std::string& energy,
                           std::vector<FormulaParameter> parameters);

/// Description of the list "Formulas": entry name = law name, "energy", "text", list "Parameters".
base::Spec formulas_spec();

/// Adds the laws of the list "Formulas" to `laws`. Throws InputError: what make_formula_law() says, a name that is
/// taken.
void add_formulas(const base::List& list, Laws& laws);

}  // namespace toile::material
