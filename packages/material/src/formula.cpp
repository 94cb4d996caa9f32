#include "toile/material/formula.hpp"

#include <algorithm>
#include <cmath>

#include "formula_program.hpp"
#include "toile/base/error.hpp"

namespace toile::material {
namespace {

using formula::Program;

/// Everything that a LawV1 points to.
struct FormulaLaw {
  std::string name, text;
  std::vector<FormulaParameter> parameters;
  std::vector<ParamInfo> info;
  Program program;
  LawV1 law;
};

/// Memory of one thread for values of type T, kept from call to call.
template <class T>
T* scratch(int n) {
  static thread_local std::vector<T> memory;
  if (memory.size() < static_cast<std::size_t>(n)) memory.resize(static_cast<std::size_t>(n));
  return memory.data();
}

/// What evaluate_block() differentiates: a program whose slots without C are filled.
struct Bound {
  const Program& program;

  template <class T, class P>
  [[gnu::noinline]] T energy(const PlaneC<T>& c, const P* p) const {
    return formula::run_field(program, c, p, scratch<T>(program.field_slots));
  }
};

/// dS/dp of one block, one parameter after the other.
void evaluate_sensitivity(const Program& program, int n, const detail::Block& block, const Lane* values, double* dSdp) {
  using P = Fad<Lane, 1>;
  using T = Fad<P, 3>;
  std::vector<P> p(program.uniform_slots);
  for (int k = 0; k < program.n_params; ++k) {
    for (int j = 0; j < program.n_params; ++j) p[j] = P(values[j]);
    p[k].fastAccessDx(0) = 1.0;
    formula::run_uniform(program, p.data());
    const auto variable = [&](int a) { return T(3, a, P(block.C[a])); };
    const T energy = Bound{program}.energy(PlaneC<T>(variable(0), variable(1), variable(2)), p.data());
    for (int a = 0; a < 3; ++a)
      detail::store(block, detail::strain_factor[a] * energy.fastAccessDx(a).fastAccessDx(0),
                    dSdp + (static_cast<long>(a) * program.n_params + k) * n);
  }
}

int evaluate(const void* context, int n, const double* C, const double* params, int param_stride, double* W, double* S,
             double* D, double* thickness_stretch, double* dSdp, std::uint8_t* status) {
  const Program& program = static_cast<const FormulaLaw*>(context)->program;
  const Bound bound = {program};
  Lane* values = scratch<Lane>(program.uniform_slots);
  if (param_stride == 0) {
    std::copy(params, params + program.n_params, values);
    formula::run_uniform(program, values);
  }
  int bad = 0;
  for (int first = 0; first < n; first += lanes) {
    detail::Block block = detail::load(n, first, C);
    if (param_stride != 0) {
      for (int k = 0; k < program.n_params; ++k)
        values[k] = Lane::load(params + static_cast<long>(k) * n + first, block.count);
      formula::run_uniform(program, values);
    }
    const Lane* p = values;
    const LaneMask extrapolated =
        D ? detail::evaluate_block<detail::Hessian>(bound, n, block, p, W, S, D, thickness_stretch)
          : detail::evaluate_block<detail::Gradient>(bound, n, block, p, W, S, nullptr, thickness_stretch);
    if (dSdp) evaluate_sensitivity(program, n, block, values, dSdp);
    bad += detail::store_status(block, extrapolated, status);
  }
  return bad;
}

int check(const void* context, const double* params, char* message, int length) {
  const auto& info = static_cast<const FormulaLaw*>(context)->info;
  return detail::check_ranges(info.data(), static_cast<int>(info.size()), params, message, length);
}

/// What goes before the text of a problem: where it is, and after it the formula, or what of it is near, with a caret
/// below the place.
std::string explain(const formula::Problem& problem, std::string energy) {
  constexpr std::size_t around = 60;
  std::replace_if(
      energy.begin(), energy.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
  const std::string where = "character " + std::to_string(problem.position + 1) + ": " + problem.what();
  std::size_t begin = 0;
  if (energy.size() > 4 * around) {
    begin = problem.position > around ? problem.position - around : 0;
    energy = energy.substr(std::min(begin, energy.size()), 2 * around);
  }
  return where + "\n  " + energy + "\n  " + std::string(problem.position - begin, ' ') + "^";
}

bool is_identifier(const std::string& name) {
  const auto letter = [](char c) { return c == '_' || (std::isalpha(static_cast<unsigned char>(c)) != 0); };
  return !name.empty() && letter(name.front()) && std::all_of(name.begin(), name.end(), [&](char c) {
    return letter(c) || (std::isdigit(static_cast<unsigned char>(c)) != 0);
  });
}

void require_free_name(const std::string& name) {
  if (!is_identifier(name))
    throw base::InputError("parameter \"" + name + "\": a name in a formula is letters, digits and _");
  for (const formula::VariableInfo& variable : formula::variables())
    if (name == variable.name)
      throw base::InputError("parameter \"" + name + "\": this name means the " + variable.text + "; choose another");
  for (const char* taken : {"type", "thickness", "compression"})
    if (name == taken)
      throw base::InputError("parameter \"" + name + "\": every material has one of this name; choose another");
}

/// The variables, for the input reference.
std::string variables_text() {
  std::string text;
  for (const formula::VariableInfo& variable : formula::variables())
    text += std::string(text.empty() ? "" : ", ") + variable.name + " (" + variable.text + ")";
  return text;
}

FormulaParameter read_parameter(const base::List& list) {
  const base::Range range = base::Range::between(list.real("lower"), list.real("upper"));
  if (range.lower > range.upper) list.fail("upper", "the range is empty: \"lower\" must not be above \"upper\"");
  const double value = list.real("value");
  if (!std::isnan(value) && !range.contains(value))
    list.fail("value", "the default is outside the parameter's own range: " + range.text());
  return {list.name(), list.word("unit"), list.word("text"), value, range.lower, range.upper};
}

}  // namespace

Laws::Law make_formula_law(const std::string& name, const std::string& text, const std::string& energy,
                           std::vector<FormulaParameter> parameters) {
  const auto law = std::make_shared<FormulaLaw>();
  law->name = name;
  law->text = text + (text.empty() ? "" : " ") + "W = " + energy;
  law->parameters = std::move(parameters);
  std::vector<std::string> names;
  for (const FormulaParameter& p : law->parameters) {
    require_free_name(p.name);
    names.push_back(p.name);
    law->info.push_back({p.name.c_str(), p.unit.c_str(), p.text.c_str(), p.fallback, p.lower, p.upper, 0});
  }
  try {
    law->program = formula::translate(energy, names);
  } catch (const formula::Problem& problem) {
    throw base::InputError(explain(problem, energy));
  }
  law->law = {material_abi, law->name.c_str(), law->text.c_str(), static_cast<int>(names.size()), law->info.data(),
              &check,       &evaluate};
  law->law.context = law.get();
  return {law, &law->law};
}

base::Spec formulas_spec() {
  base::Spec parameter("parameter", "One parameter of the energy, by its name in the formula.");
  parameter.real("value", "", "Default value in its unit; without one, every material must give it.", no_default)
      .word("unit", "Its unit, for messages and descriptions.", std::string())
      .real("lower", "", "Least value that is allowed.", -infinity)
      .real("upper", "", "Greatest value that is allowed.", infinity)
      .word("text", "What it is.", std::string());
  base::Spec law("law", "One energy, by the name of its law.");
  law.word("energy",
           "Energy per reference volume (MPa). Names: the parameters, " + variables_text() +
               ". Operators + - * / ^; functions ln, exp, sqrt, sin, cos, min, max, if(a < b, then, else). Definitions "
               "may go before: \"e = ln(l1); k*e^2\".")
      .word("text", "What it is.", std::string())
      .list(base::Spec("Parameters", "The parameters of the energy, by name.").entries(parameter));
  return base::Spec("Formulas",
                    "Fabrics by an energy that is typed here, by the name of their law, which a material names as its "
                    "\"type\". Stress and tangent follow by differentiation.")
      .entries(law);
}

void add_formulas(const base::List& list, Laws& laws) {
  for (const base::List& entry : list.entries()) {
    std::vector<FormulaParameter> parameters;
    if (entry.has_list("Parameters"))
      for (const base::List& p : entry.list("Parameters").entries()) parameters.push_back(read_parameter(p));
    Laws::Law law;
    try {
      law = make_formula_law(entry.name(), entry.word("text"), entry.word("energy"), std::move(parameters));
    } catch (const base::InputError& error) {
      entry.fail("energy", error.what());
    }
    if (!laws.add(law))
      entry.fail("energy", "there is a law named \"" + entry.name() + "\" already; choose another name");
  }
}

}  // namespace toile::material
