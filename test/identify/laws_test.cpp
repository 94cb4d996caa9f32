#include <gmock/gmock.h>

#include <sstream>

#include "base/scene.hpp"
#include "fabric_tests.hpp"
#include "toile/base/error.hpp"
#include "toile/identify/curve_models.hpp"
#include "toile/identify/report.hpp"
#include "toile/material/read_laws.hpp"

namespace toile::identify::test {
namespace {

using ::testing::HasSubstr;

const std::vector<VirtualTest> wale = {{"wale", "uniaxial", 0.0, 1.9}};
const std::string one_start = parameter("starts", "int", "1") + parameter("generations", "int", "50");

/// List "Formulas" with the law "typed", which is the rebar law along the wale up to the second coefficient; `range`:
/// that of each parameter.
std::string typed_rebar(const std::string& range) {
  std::string parameters;
  for (const char* name : {"C10", "c0", "c1"}) parameters += list(name, parameter("unit", "string", "MPa") + range);
  const std::string energy = "e = if(C11 &lt; 1, 0, ln(l1)); C10*(I1 - 3) + c0*e^2/2 + c1*e^3/6";
  return list("Formulas", list("typed", parameter("energy", "string", energy) +
                                            parameter("text", "string", "Fibres &amp; &quot;matrix&quot;.") +
                                            list("Parameters", parameters)));
}

const std::string free_fibre =
    free_parameter("C10", 1e-4, 0.1, true) + free_parameter("c0", -1.0, 1.0) + free_parameter("c1", -1.0, 1.0);

struct Fitted {
  FitProblem problem;
  FitResult result;
};

/// The laws are gone when this returns: the problem keeps the one that it needs.
Fitted fitted(const FitFolder& folder) {
  const base::List input = folder.read();
  FitProblem problem(input, folder.laws());
  FitResult result = fit(problem, Algorithm(input.list("Algorithm")), [](const FitStatus&) {});
  return {std::move(problem), std::move(result)};
}

/// A law of one fibre with the fit file's other lists; `energy` in c, k and m.
void write_fibre_fit(const FitFolder& folder, const std::string& energy, const std::string& free,
                     const std::vector<VirtualTest>& tests, const std::string& algorithm) {
  folder.write_fit(
      parameter("type", "string", "fibre"), free, "", tests, algorithm,
      list("Formulas", list("fibre", parameter("energy", "string", energy) +
                                         list("Parameters", list("c", "") + list("k", "") + list("m", "")))));
}

// An exponent can be fitted where its base is zero: in a fabric pulled along the course the fibre of the wale is slack.
// The law made the data, and its values are found.
TEST(Formula, ExponentOfASlackFibreIsFitted) {
  constexpr double c = 0.02, k = 0.03, m = 2.6;
  const FitFolder folder;
  const std::vector<VirtualTest> tests = {{"wale", "uniaxial", 0.0, 1.6}, {"course", "uniaxial", 90.0, 1.6}};
  folder.measure(tests, 0.0);
  write_fibre_fit(folder, "c/2*(I1 - 3) + k*max(C11 - 1, 0)^m",
                  free_parameter("c", 1e-3, 1.0, true) + free_parameter("k", 0.0, 1.0) + free_parameter("m", 2.0, 8.0),
                  tests, one_start);
  const FitProblem law_of(folder.read(), folder.laws());
  const double params[] = {c, k, m};
  for (const Curve& curve : law_of.curves()) {
    std::vector<double> stress(curve.stretch.size());
    ASSERT_EQ(forward_model({curve})->stress(law_of.law(), params, stress.data()), 0);
    std::ostringstream rows;
    rows.precision(17);
    rows << "stretch [-], nominal stress [MPa]\n";
    for (std::size_t i = 0; i < stress.size(); ++i) rows << curve.stretch[i] << "," << stress[i] << "\n";
    folder.write(curve.name + ".csv", rows.str());
  }
  const Fitted f = fitted(folder);
  EXPECT_NEAR(f.result.params[0], c, 1e-5 * c);
  EXPECT_NEAR(f.result.params[1], k, 1e-5 * k);
  EXPECT_NEAR(f.result.params[2], m, 1e-5 * m);
}

// A law whose stress must fall is fitted, but where it falls is part of the result and of its report.
TEST(Formula, FallingStressIsTold) {
  const std::vector<VirtualTest> tests = {{"wale", "uniaxial", 0.0, 1.6}};
  const FitFolder folder;
  folder.measure(tests, 0.0);
  write_fibre_fit(folder, "c/2*(I1 - 3) + k*(l1 - 1)^2 - m*(l1 - 1)^4",
                  free_parameter("c", 0.001, 0.01) + free_parameter("k", 0.01, 0.1) + free_parameter("m", 0.2, 1.0),
                  tests, one_start + parameter("keep tangent positive", "bool", "true"));
  const Fitted f = fitted(folder);
  EXPECT_THAT(f.result.falls, HasSubstr("curve \"wale\" at stretch "));
  EXPECT_THAT(
      report_text(f.problem, f.result, curve_reports(f.problem, f.result.params),
                  parameter_statistics(f.problem, f.result)),
      HasSubstr("the stress does not rise everywhere, as was asked for: it falls to that of " + f.result.falls));
}

// A fit that finds no parameters with a state at every point has no result, and says which curve has none.
TEST(Formula, WithoutStatesThereIsNoResult) {
  const std::vector<VirtualTest> tests = {{"wale", "uniaxial", 0.0, 1.6}};
  const FitFolder folder;
  folder.measure(tests, 0.0);
  // Its lateral stress has no zero: it pulls together without end.
  write_fibre_fit(folder, "c*(C11 - 1)^2 + k*(C12^2) + m*C22",
                  free_parameter("c", 0.1, 1.0) + free_parameter("k", 0.1, 1.0) + free_parameter("m", 0.1, 1.0), tests,
                  one_start);
  try {
    fitted(folder);
    FAIL() << "it has a result";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ExitCode::solve_failed);
    EXPECT_THAT(error.what(), HasSubstr("there is none for curve \"wale\" at stretch 1.0"));
  }
}

// A typed energy is fitted as the same compiled law is: equal parameters to 1e-6, from data with 2 % noise.
TEST(Formula, IsFittedAsTheCompiledLaw) {
  const FitFolder folder;
  folder.measure(wale, 0.02);
  folder.write_fit(parameter("type", "string", "rebar") + parameter("d0", "double", "0"), free_fibre, "", wale,
                   one_start);
  const Fitted compiled = fitted(folder);
  folder.write_fit(parameter("type", "string", "typed"), free_fibre, "", wale, one_start, typed_rebar(""));
  const Fitted typed = fitted(folder);
  ASSERT_EQ(typed.result.params.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const double expected = compiled.result.params[static_cast<std::size_t>(compiled.problem.free()[k].index)];
    EXPECT_NEAR(typed.result.params[k], expected, 1e-6 * std::abs(expected)) << k;
    EXPECT_NE(expected, 0.0);
  }
}

// A fit's file for a scene holds the formula too, and reads back as the same law with the same values.
TEST(Report, IncludeFileHoldsTheFormula) {
  const FitFolder folder;
  folder.measure(wale, 0.02);
  folder.write_fit(parameter("type", "string", "typed"), free_fibre, "", wale, "",
                   typed_rebar(parameter("lower", "double", "-1") + parameter("value", "double", "0.5")));
  const FitProblem problem(folder.read(), folder.laws());
  const std::vector<double> params = problem.params({1.0 / 3.0, 0.2, 0.7});
  folder.write("include.xml", include_xml(problem, params, folder.read(), folder.path("")));

  const material::Laws laws = material::read_laws(folder.path("include.xml"), "scene", false);
  const base::Spec spec = base::Spec("Materials", "").entries(material::material_spec(laws));
  const material::Material read(base::read_part(folder.path("include.xml"), "scene", spec)->entries().front(), laws);
  EXPECT_EQ(read.params(), params);
  EXPECT_STREQ(read.law().text, problem.law().text);
  for (int i = 0; i < 3; ++i) {
    const material::ParamInfo &found = read.law().info[i], &expected = problem.law().info[i];
    EXPECT_STREQ(found.unit, expected.unit);
    EXPECT_EQ(found.fallback, expected.fallback);
    EXPECT_EQ(found.lower, expected.lower);
    EXPECT_EQ(found.upper, expected.upper);
  }
}

/// Message for a fit of the typed law.
std::string typed_error(const std::string& free, const std::string& formulas) {
  const FitFolder folder;
  folder.measure(wale, 0.02);
  folder.write_fit(parameter("type", "string", "typed"), free, "", wale, "", formulas);
  return base::test::input_error([&] { FitProblem problem(folder.read(), folder.laws()); });
}

// A parameter of a formula that was declared without a range needs bounds in "Free"; one with a range does not.
TEST(BadFormula, NeedsBounds) {
  const std::string open = list("C10", "") + list("c0", "") + list("c1", "");
  EXPECT_THAT(typed_error(open, typed_rebar("")),
              HasSubstr("fit > Free > C10: parameter \"lower\" (not given): must be given, because the material "
                        "does not bound \"C10\": the search needs a finite interval"));
  const FitFolder folder;
  folder.measure(wale, 0.02);
  folder.write_fit(parameter("type", "string", "typed"), open, "", wale, "",
                   typed_rebar(parameter("lower", "double", "-1") + parameter("upper", "double", "0.5")));
  const FitProblem problem(folder.read(), folder.laws());
  EXPECT_EQ(problem.free()[1].lower, -1.0);
  EXPECT_EQ(problem.free()[1].upper, 0.5);
}

// A formula of a fit file that does not parse: the list, the place, the nearest name.
TEST(BadFormula, DoesNotParse) {
  const std::string formulas = list(
      "Formulas", list("typed", parameter("energy", "string", "mu/2*(Il - 3)") + list("Parameters", list("mu", ""))));
  const std::string message = typed_error(free_parameter("mu", 0.0, 1.0), formulas);
  EXPECT_THAT(message,
              HasSubstr("fit.xml: fit > Formulas > typed: parameter \"energy\" = \"mu/2*(Il - 3)\": character 7: "
                        "unknown name \"Il\"; did you mean \""));
  EXPECT_THAT(message, HasSubstr("\n  mu/2*(Il - 3)\n        ^"));
}

}  // namespace
}  // namespace toile::identify::test
