#include "toile/material/formula.hpp"

#include <gmock/gmock.h>

#include <Teuchos_ParameterList.hpp>

#include "derivatives.hpp"
#include "formulas.hpp"
#include "input_error.hpp"
#include "mutation.hpp"
#include "toile/base/error.hpp"

namespace toile::material::test {
namespace {

using ::testing::HasSubstr;

FormulaParameter number(const std::string& name) {
  return {name, "", "", 1.0, -1e3, 1e3};
}

std::string refusal(const std::string& energy) {
  return input_error([&] { make_formula_law("mine", "", energy, {number("mu"), number("k")}); });
}

/// What is said of a formula that is good: nothing.
std::string translated(const std::string& energy) {
  make_formula_law("mine", "", energy, {number("mu"), number("k")});
  return "";
}

/// W, S, D and dS/dp of both laws at sheared states between `low` and `high`, to 1e-12 of the largest of each.
void expect_same(const LawV1& formula, const LawV1& built_in, const std::vector<double>& params, double low,
                 double high) {
  const int n = 37;  // several blocks and an odd rest
  const std::vector<State> states = random_states(n, low, high, 3);
  std::vector<double> C(3 * n);
  for (int i = 0; i < n; ++i)
    for (int a = 0; a < 3; ++a) C[a * n + i] = states[i][a];
  const auto all = [&](const LawV1& law) {
    std::vector<double> W(n), S(3 * n), D(6 * n), h(n), dSdp(3 * n * law.n_params);
    std::vector<std::uint8_t> status(n);
    EXPECT_EQ(law.evaluate(law.context, n, C.data(), params.data(), 0, W.data(), S.data(), D.data(), h.data(),
                           dSdp.data(), status.data()),
              0);
    EXPECT_THAT(status, ::testing::Each(point_ok));
    std::vector<double> by_common;
    for (int a = 0; a < 3; ++a)
      for (int k = 0; k < formula.n_params; ++k)
        for (int i = 0; i < n; ++i) by_common.push_back(dSdp[(a * law.n_params + k) * n + i]);
    return std::vector<std::vector<double>>{W, S, D, h, by_common};
  };
  const auto found = all(formula), expected = all(built_in);
  for (std::size_t q = 0; q < found.size(); ++q) {
    double scale = 0.0;
    for (const double value : expected[q]) scale = std::max(scale, std::abs(value));
    EXPECT_GT(scale, 0.0);
    for (std::size_t i = 0; i < found[q].size(); ++i)
      EXPECT_NEAR(found[q][i], expected[q][i], 1e-12 * scale) << formula.name << " quantity " << q << " entry " << i;
  }
}

// Built-in laws written as formulas give the built-in energy, stress, tangent, thickness and derivatives by parameters.
TEST(Formula, same_as_built_in) {
  expect_same(*formula_like("neo-hookean", 1, neo_hookean_formula), law("neo-hookean"),
              values("neo-hookean", "pantyhose"), 0.7, 2.2);
  expect_same(*formula_like("rebar", 13, rebar_formula), law("rebar"), values("rebar", "pantyhose"), 0.7, 2.0);
  expect_same(*formula_like("itskov", 15, itskov_formula()), law("itskov"), values("itskov", "pantyhose"), 0.7, 2.0);
}

// Parameters that vary from point to point reach each point: the same as one point at a time.
TEST(Formula, graduated) {
  const Laws::Law formula = formula_like("neo-hookean", 1, "e = 2*C10; e*(I1 - 3)/2");
  const int n = 11;
  std::vector<double> C(3 * n), C10(n), W(n), S(3 * n), h(n);
  std::vector<std::uint8_t> status(n);
  for (int i = 0; i < n; ++i) {
    C[i] = 1.0 + 0.1 * i;
    C[n + i] = 1.3;
    C10[i] = 0.5 + i;
  }
  formula->evaluate(formula->context, n, C.data(), C10.data(), 1, W.data(), S.data(), nullptr, h.data(), nullptr,
                    status.data());
  for (int i = 0; i < n; ++i)
    EXPECT_NEAR(W[i], evaluate(law("neo-hookean"), {C10[i]}, {C[i], 1.3, 0.0}).W, 1e-14 * (1.0 + W[i]));
}

// Every function, operator and variable has its derivatives: stress and tangent against central differences.
TEST(Formula, derivatives_of_all_functions) {
  const std::string energy =
      "a = -(k - 3)^2 + +mu; q = if(C11 > 1.2, l1 - 0.3, l2^1.5); b = min(l1, 1.1)*max(E22, 0.05);"
      "mu*exp(0.1*q) + k*sin(E11)*cos(E12) + sqrt(J)*ln(I2) + 2^k/C33 + a/I1 + log(l1/mu)^3 + b^4/(1 + E12^2) + "
      "C22*C12";
  const Laws::Law formula = make_formula_law("all", "", energy, {number("mu"), number("k")});
  const Case test = {"all", formula.get(), {1.3, 0.7}};
  for (const State& C : random_states(60, 0.75, 1.6, 9)) {
    expect_derivatives(test, C);
    expect_parameter_derivatives(test, C);
  }
  // Independent of the differentiation, the value itself by hand.
  const double C11 = 1.21, C22 = 1.44, C12 = 0.2, mu = 1.3, k = 0.7, det = C11 * C22 - C12 * C12;
  const double l1 = 1.1, E11 = 0.105, E22 = 0.22, E12 = 0.1, I1 = C11 + C22 + 1.0 / det, I2 = (C11 + C22) / det + det;
  const double a = -(k - 3) * (k - 3) + mu, q = l1 - 0.3, b = l1 * E22;
  const double W = mu * std::exp(0.1 * q) + k * std::sin(E11) * std::cos(E12) + std::pow(det, 0.25) * std::log(I2) +
                   std::pow(2.0, k) * det + a / I1 + std::pow(std::log(l1 / mu), 3) +
                   std::pow(b, 4) / (1.0 + E12 * E12) + C22 * C12;
  EXPECT_NEAR(evaluate(*formula, {mu, k}, {C11, C22, C12}).W, W, 1e-13 * std::abs(W));
}

// A power of what max() makes zero is admissible where it is slack, with all of its derivatives, also by its exponent.
TEST(Formula, powers_of_zero) {
  const Laws::Law formula =
      make_formula_law("fibre", "", "c*(I1 - 3) + k*max(C11 - 1, 0)^m", {number("c"), number("k"), number("m")});
  for (const double m : {1.5, 2.0, 2.5, 3.0, 6.5}) {
    const Case test = {"m = " + std::to_string(m), formula.get(), {0.3, 0.7, m}};
    for (const State& C : {State{0.8, 1.3, 0.1}, State{1.4, 0.9, -0.1}}) {
      expect_derivatives(test, C);
      expect_parameter_derivatives(test, C);
    }
    EXPECT_EQ(evaluate(*formula, test.params, {1.0, 1.2, 0.0}).bad, 0) << m;
  }
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// What is nested so deep that it would take the whole stack is refused, however it nests; the formula is then shown
// near the place alone.
TEST(Formula, RefusesDeepNesting) {
  const std::string deep = "parentheses, signs and powers are nested more than 200 deep";
  for (const std::string& formula :
       {repeated("(", 10000) + "mu*(I1 - 3)" + repeated(")", 10000), repeated("-", 10000) + "mu*I1",
        repeated("(-", 10000) + "I1" + repeated(")", 10000), "I1*mu" + repeated("^mu", 10000),
        "I1*mu" + repeated("^1e-1", 10000), repeated("exp(", 10000) + "I1", repeated("- + ", 10000) + "I1"}) {
    const std::string message = refusal(formula);
    EXPECT_THAT(message, HasSubstr(deep)) << formula.substr(0, 40);
    EXPECT_LT(message.size(), 300U);
  }
  EXPECT_THAT(refusal(repeated("mu + ", 30000) + "I1"), HasSubstr("the formula has more than 100000 characters"));
}

// Whatever is changed in a formula, it is translated or refused as the user's.
TEST(Formula, FormulasWithFaultsAreTranslatedOrRefused) {
  const std::string text =
      "e = max(C11 - 1, 0); mu/2*(I1 - 3) + k/(2*0.8)*(exp(0.8*e^2) - 1) + if(l1 < l2, -J, ln(I2))";
  int translated = 0, refused = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    const std::string formula = toile::test::Mutation(seed)(text);
    try {
      make_formula_law("mine", "", formula, {number("mu"), number("k")});
      ++translated;
    } catch (const base::InputError&) {
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << formula << ": " << error.what();
    }
  }
  EXPECT_GT(translated, 100);
  EXPECT_GT(refused, 1000);
}

// A long formula that is not deep, and one that is as deep as anybody writes, are translated.
TEST(Formula, TakesLongAndRatherDeepFormulas) {
  EXPECT_EQ(translated("mu*(I1 - 3)" + repeated(" + mu*(I1 - 3)^2 - (I2 - 3)", 3000)), "");
  EXPECT_EQ(translated(repeated("(", 150) + "mu*(I1 - 3)" + repeated(")", 150)), "");
  EXPECT_EQ(translated("mu*I1" + repeated("*-I1^2", 300)), "");
}

// What does not parse is shown with its place: a line with the formula and a caret below the character.
TEST(Formula, mistakes_have_a_place) {
  EXPECT_EQ(refusal("mu*(I1 - 3"), "character 11: expected an operator or \")\"\n  mu*(I1 - 3\n            ^");
  EXPECT_EQ(refusal("mu*(I1 - )"),
            "character 10: expected a number, a name, a function or \"(\"\n  mu*(I1 - )\n           ^");
  EXPECT_EQ(refusal("mu*(I1 - 3) k"),
            "character 13: expected an operator or the end of the formula\n  mu*(I1 - 3) k\n              ^");
  EXPECT_THAT(refusal(""), HasSubstr("character 1: expected a number"));
  EXPECT_THAT(refusal("a = 2*k mu*I1"), HasSubstr("character 9: expected an operator or \";\""));
  EXPECT_THAT(refusal("mu*(I1\n- 3) k"), HasSubstr("\n  mu*(I1 - 3) k\n              ^"));
}

// An unknown name or function is told with its place and the nearest known one.
TEST(Formula, unknown_names) {
  EXPECT_THAT(refusal("mu*(C11 + C13 - 2)"),
              HasSubstr("character 11: unknown name \"C13\"; did you mean \"C11\"? Valid here: "));
  EXPECT_THAT(refusal("nu*(I1 - 3)"), HasSubstr("unknown name \"nu\"; did you mean \"mu\"?"));
  EXPECT_THAT(refusal("strain = ln(l1); mu*strian^2"), HasSubstr("did you mean \"strain\"?"));
  EXPECT_THAT(refusal("mu*sqr(I1)"), HasSubstr("character 4: unknown function \"sqr\"; did you mean \"sqrt\"?"));
}

// What parses but has no meaning.
TEST(Formula, meaningless) {
  EXPECT_THAT(refusal("mu*2^C11"), HasSubstr("character 6: an exponent may not depend on the deformation"));
  EXPECT_THAT(refusal("mu + k"), HasSubstr("the energy does not depend on the deformation"));
  EXPECT_THAT(refusal("I1 = 2; mu*I1"), HasSubstr("character 1: \"I1\" has a meaning already"));
  EXPECT_THAT(refusal("mu*max(C11)"), HasSubstr("character 4: \"max\" takes 2 argument(s), found 1"));
  EXPECT_THAT(refusal("mu*ln(C11 < 2)"), HasSubstr("character 11: a comparison stands only first in if"));
  EXPECT_THAT(refusal("mu*if(C11, 1, 2)"), HasSubstr("character 7: expected a comparison"));
  EXPECT_THAT(input_error([] { make_formula_law("mine", "", "J*I1", {number("J")}); }),
              HasSubstr("parameter \"J\": this name means the change of area"));
  EXPECT_THAT(input_error([] { make_formula_law("mine", "", "a*I1", {number("a b")}); }),
              HasSubstr("parameter \"a b\": a name in a formula is letters, digits and _"));
}

// Where the energy is not a number it is refused, point by point; never a silent NaN.
TEST(Formula, not_a_number_is_refused) {
  const Laws::Law formula = make_formula_law("mine", "", "mu*ln(C11 - 1.5) + k", {number("mu"), number("k")});
  EXPECT_EQ(evaluate(*formula, {1.0, 1.0}, {1.2, 1.0, 0.0}).status, point_not_admissible);
  EXPECT_EQ(evaluate(*formula, {1.0, 1.0}, {2.0, 1.0, 0.0}).status, point_ok);
}

Teuchos::ParameterList formulas(const std::string& name, const std::string& energy) {
  Teuchos::ParameterList list;
  list.sublist(name).set("energy", energy);
  Teuchos::ParameterList& mu = list.sublist(name).sublist("Parameters").sublist("mu");
  mu.set("unit", "MPa");
  mu.set("lower", 0.0);
  mu.set("upper", 2.0);
  return list;
}

Laws laws_of(const Teuchos::ParameterList& list) {
  Laws laws;
  add_formulas(base::validate(list, formulas_spec(), "scene.xml"), laws);
  return laws;
}

std::string use(const Laws& laws, const Teuchos::ParameterList& fabric) {
  return input_error([&] { Material(base::validate(fabric, material_spec(laws), "scene.xml"), laws); });
}

// A formula is a law like any other: parameters with unit and range, required ones, unknown ones with the nearest name.
TEST(Formulas, are_laws) {
  const Laws laws = laws_of(formulas("mine", "mu*(I1 - 3)"));
  EXPECT_EQ(Laws().find("mine"), nullptr);
  Teuchos::ParameterList fabric;
  fabric.set("type", "mine");
  EXPECT_THAT(use(laws, fabric), HasSubstr("missing parameter \"mu\""));
  fabric.set("mu", 3.0);
  EXPECT_THAT(use(laws, fabric), HasSubstr("parameter \"mu\" is out of range: 3 MPa, allowed: 0 <= value <= 2"));
  fabric.set("mu", 1.0);
  EXPECT_EQ(use(laws, fabric), "accepted");
  fabric.set("mv", 1.0);
  EXPECT_THAT(use(laws, fabric), HasSubstr("unknown parameter \"mv\"; did you mean \"mu\"?"));
}

// A formula whose natural state has energy or stress is refused with the values.
TEST(Formulas, natural_state) {
  Teuchos::ParameterList fabric;
  fabric.set("type", "mine");
  fabric.set("mu", 0.5);
  EXPECT_THAT(use(laws_of(formulas("mine", "mu*(C11 + C22 - 2)")), fabric),
              HasSubstr("must be free of energy and stress, but there W = 0, S11 = 1, S22 = 1, S12 = 0 MPa"));
  EXPECT_THAT(use(laws_of(formulas("mine", "mu*(I1 - 2)")), fabric), HasSubstr("but there W = 0.5, S11 = 0, "));
}

// The list's messages name the entry; a name that a built-in law has is refused.
TEST(Formulas, messages) {
  EXPECT_THAT(input_error([] { laws_of(formulas("mine", "mu*(I1 -")); }),
              HasSubstr("scene.xml: Formulas > mine: parameter \"energy\" = \"mu*(I1 -\": character 9: expected"));
  EXPECT_THAT(input_error([] { laws_of(formulas("rebar", "mu*(I1 - 3)")); }),
              HasSubstr("there is a law named \"rebar\" already"));
}

// A parameter whose range is empty, or whose default is outside it, is refused where it is declared.
TEST(Formulas, ranges) {
  Teuchos::ParameterList list = formulas("mine", "mu*(I1 - 3)");
  Teuchos::ParameterList& mu = list.sublist("mine").sublist("Parameters").sublist("mu");
  mu.set("value", 3.0);
  EXPECT_THAT(input_error([&] { laws_of(list); }),
              HasSubstr("scene.xml: Formulas > mine > Parameters > mu: parameter \"value\" = 3: the default is outside "
                        "the parameter's own range: 0 <= value <= 2"));
  mu.set("upper", -1.0);
  EXPECT_THAT(
      input_error([&] { laws_of(list); }),
      HasSubstr("Formulas > mine > Parameters > mu: parameter \"upper\" = -1: the range is empty: \"lower\" must "
                "not be above \"upper\""));
}

}  // namespace
}  // namespace toile::material::test
