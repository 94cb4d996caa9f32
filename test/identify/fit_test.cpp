#include <gmock/gmock.h>

#include <cmath>
#include <iostream>

#include "fabric_tests.hpp"
#include "toile/identify/report.hpp"
#include "toile/identify/residuals.hpp"

namespace toile::identify::test {
namespace {

using ::testing::HasSubstr;

const std::vector<VirtualTest> tensile = {
    {"wale", "uniaxial", 0.0, 2.0}, {"course", "uniaxial", 90.0, 2.2}, {"bias", "uniaxial", 45.0, 2.1}};

std::vector<VirtualTest> all_tests(double biaxial_weight) {
  std::vector<VirtualTest> tests = tensile;
  tests.push_back({"equibiaxial wale", "equibiaxial", 0.0, 1.7, biaxial_weight});
  tests.push_back({"equibiaxial course", "equibiaxial", 90.0, 1.7, biaxial_weight});
  return tests;
}

struct Outcome {
  FitProblem problem;
  FitResult result;
  std::vector<CurveReport> reports;
};

Outcome run(const FitFolder& folder) {
  const base::List input = folder.read();
  FitProblem problem(input);
  FitResult result = fit(problem, Algorithm(input.list("Algorithm")), [](const FitStatus&) {});
  std::vector<CurveReport> reports = curve_reports(problem, result.params);
  return {std::move(problem), std::move(result), std::move(reports)};
}

Outcome itskov_fit(double biaxial_weight, const std::string& algorithm = "") {
  const FitFolder folder;
  folder.measure(all_tests(biaxial_weight), 0.02);
  folder.write_fit(parameter("type", "string", "itskov"), itskov_free(), itskov_conditions(), all_tests(biaxial_weight),
                   algorithm);
  return run(folder);
}

// Tensile and equibiaxial data with 2 % noise from the published Itskov set: the fit is within 3 % of the exact tensile
// curves and within 5 % of the exact biaxial ones, everywhere, over the curve's largest stress.
TEST(Fit, ItskovWithBiaxialData) {
  const Outcome o = itskov_fit(1.0);
  for (std::size_t c = 0; c < o.reports.size(); ++c) {
    const double error = largest_error(o.problem.curves()[c], o.reports[c]);
    std::cout << o.reports[c].name << (o.reports[c].fitted ? ", fitted: " : ", predicted: ") << 100.0 * error
              << " % of its largest stress\n";
    EXPECT_LT(error, c < tensile.size() ? 0.03 : 0.05) << o.reports[c].name;
  }
}

// Without the biaxial data the tensile curves are within 3 % everywhere, and the report says by how much the predicted
// biaxial stress is off: more than 5 %, and as much as it is off the exact one.
TEST(Fit, ItskovWithoutBiaxialData) {
  const Outcome o = itskov_fit(0.0);
  for (std::size_t c = 0; c < o.reports.size(); ++c) {
    const double error = largest_error(o.problem.curves()[c], o.reports[c]);
    std::cout << o.reports[c].name << (o.reports[c].fitted ? ", fitted: " : ", predicted: ") << 100.0 * error
              << " % of its largest stress\n";
    EXPECT_EQ(o.reports[c].fitted, c < tensile.size());
    if (c < tensile.size()) {
      EXPECT_LT(error, 0.03) << o.reports[c].name;
    } else {
      EXPECT_GT(o.reports[c].relative, 0.05) << o.reports[c].name;
      EXPECT_NEAR(std::abs(o.reports[c].largest_relative), error, 0.06 * (1.0 + error)) << o.reports[c].name;
    }
  }
}

std::string fibre_free(const std::string& fibre) {
  std::string text;
  for (const std::string order : {"0", "1", "2", "3", "4", "5"})
    text += free_parameter(fibre + order, order == "0" ? 0.0 : -200.0, order == "0" ? 1.0 : 200.0);
  return text;
}

std::vector<VirtualTest> with_bias_weight(double weight) {
  std::vector<VirtualTest> tests = tensile;
  tests.back().weight = weight;
  return tests;
}

// The rebar model cannot follow the fabric in bias: fitted to wale and course it predicts, and fitted to all three
// curves it still gives, too low a stress at the largest bias stretch. Its stresses rise, as was asked for.
TEST(Fit, RebarIsTooSoftInBias) {
  for (const double weight : {0.0, 1.0}) {
    const FitFolder folder;
    folder.measure(tensile, 0.02);
    folder.write_fit(parameter("type", "string", "rebar"),
                     free_parameter("C10", 1e-4, 0.1, true) + fibre_free("c") + fibre_free("d"), "",
                     with_bias_weight(weight), parameter("keep tangent positive", "bool", "true"));
    const Outcome o = run(folder);
    for (const CurveReport& r : o.reports)
      std::cout << r.name << (r.fitted ? " fitted" : " predicted") << ": rms " << 100.0 * r.relative
                << " %, at the end " << 100.0 * r.end_relative << " %\n";
    EXPECT_LT(o.reports[2].end_relative, -0.05) << weight;
    EXPECT_LT(o.reports[2].stress.back(), exact(o.problem.curves()[2]).back()) << weight;
    Residuals residuals(o.problem);
    residuals.chi_squared(o.result.x());
    EXPECT_GE(residuals.smallest_rise(), 0.0) << weight;
  }
}

// The same seed gives the same parameters, bit for bit, with either search; another seed other ones.
TEST(Fit, SameSeedSameResult) {
  for (const std::string search : {"differential evolution", "genetic algorithm"}) {
    const auto params = [&](const std::string& seed) {
      return itskov_fit(1.0, parameter("search", "string", search) + parameter("generations", "int", "35") +
                                 parameter("starts", "int", "2") + parameter("seed", "int", seed))
          .result.params;
    };
    const std::vector<double> first = params("5");
    EXPECT_EQ(params("5"), first) << search;
    EXPECT_NE(params("8"), first) << search;
  }
}

/// Neo-Hookean fabric in tension: P = mu (l - 1/l^2), mu = 2 C10.
void neo_hookean(const FitFolder& folder, const std::string& rows) {
  folder.write("wale.csv", "stretch [-], nominal stress [MPa]\n" + rows);
  folder.write_fit(parameter("type", "string", "neo-hookean"), free_parameter("C10", 1e-3, 1.0, true), "",
                   {{"wale", "uniaxial", 0.0, 2.0}},
                   parameter("generations", "int", "20") + parameter("starts", "int", "1"));
}

double per_c10(double l) {
  return 2.0 * (l - 1.0 / (l * l));
}

// A law with one parameter: value, standard deviation s / |J| and noise s are those of weighted linear least squares.
TEST(Fit, StatisticsOfOneParameter) {
  const FitFolder folder;
  const std::vector<double> stretch = {1.2, 1.5, 2.0}, stress = {0.021, 0.039, 0.073};
  std::string rows;
  for (std::size_t i = 0; i < 3; ++i) rows += std::to_string(stretch[i]) + "," + std::to_string(stress[i]) + "\n";
  neo_hookean(folder, rows);
  const Outcome o = run(folder);
  double ff = 0.0, fd = 0.0, chi = 0.0;
  const std::vector<double>& sigma = o.problem.curves()[0].deviation;
  for (std::size_t i = 0; i < 3; ++i) {
    const double f = per_c10(stretch[i]) / sigma[i];
    ff += f * f;
    fd += f * stress[i] / sigma[i];
  }
  const double C10 = fd / ff;
  for (std::size_t i = 0; i < 3; ++i) chi += std::pow((C10 * per_c10(stretch[i]) - stress[i]) / sigma[i], 2);
  const ParameterStatistics s = parameter_statistics(o.problem, o.result);
  EXPECT_NEAR(o.result.params[0], C10, 1e-6 * C10);
  EXPECT_NEAR(s.noise, std::sqrt(chi / 2.0), 1e-6 * s.noise);
  EXPECT_NEAR(s.deviation[0], s.noise / std::sqrt(ff), 1e-6 * s.deviation[0]);
}

// Parameters that no curve depends on (course fibres are slack in wale tension) are told apart from those that the data
// determine.
TEST(Fit, NamesWhatDataCannotDetermine) {
  const FitFolder folder;
  folder.measure({tensile[0]}, 0.02);
  folder.write_fit(parameter("type", "string", "rebar") + parameter("C10", "double", "0.008"),
                   free_parameter("c0", 0.0, 1.0) + free_parameter("d0", 0.1, 1.0), "", {tensile[0]},
                   parameter("generations", "int", "20") + parameter("starts", "int", "1"));
  const Outcome o = run(folder);
  const ParameterStatistics s = parameter_statistics(o.problem, o.result);
  EXPECT_TRUE(std::isfinite(s.deviation[0]));
  EXPECT_TRUE(std::isinf(s.deviation[1]));
  EXPECT_TRUE(std::isfinite(s.covariance[0]));
  for (int i = 1; i < 4; ++i) EXPECT_TRUE(std::isnan(s.covariance[i])) << i;
  EXPECT_GT(s.combinations.back().deviation, undetermined);
  EXPECT_EQ(combination_text(o.problem, s.combinations.back()), "1 d0");
}

// Candidates that the law refuses are moved to the edge of what it accepts: the weights of every term add up to at most
// one, although nothing but the law says so.
TEST(Fit, KeepsTheLawsOwnConditions) {
  const FitFolder folder;
  folder.measure(tensile, 0.02);
  folder.write_fit(parameter("type", "string", "itskov"), itskov_free(), "", tensile,
                   parameter("generations", "int", "50") + parameter("starts", "int", "1"));
  const Outcome o = run(folder);
  for (const int w1 : {3, 8, 13}) EXPECT_LE(o.result.params[w1] + o.result.params[w1 + 1], 1.0 + 1e-12) << w1;
  const std::vector<double> edge = o.problem.params(o.problem.repaired(std::vector<double>(15, 1.0)));
  EXPECT_NEAR(edge[3] + edge[4], 1.0, 1e-9);
}

// Data whose stress falls: the fit follows them, unless it must keep its tangent positive.
TEST(Fit, KeepsTheTangentPositive) {
  double smallest[2] = {};
  for (const bool keep : {false, true}) {
    const FitFolder folder;
    folder.write("wale.csv",
                 "stretch [-], nominal stress "
                 "[MPa]\n1.1,0.01\n1.2,0.03\n1.3,0.05\n1.35,0.045\n1.4,0.04\n1.45,0.035\n1.5,0.03\n1.6,0.05\n");
    folder.write_fit(parameter("type", "string", "rebar") + parameter("d0", "double", "0"),
                     free_parameter("C10", 1e-4, 0.1, true) + fibre_free("c"), "", {{"wale", "uniaxial", 0.0, 1.6}},
                     parameter("keep tangent positive", "bool", keep ? "true" : "false"));
    const Outcome o = run(folder);
    Residuals residuals(o.problem);
    residuals.chi_squared(o.result.x());
    smallest[keep ? 1 : 0] = residuals.smallest_rise();
  }
  EXPECT_LT(smallest[0], -0.05);
  EXPECT_GE(smallest[1], 0.0);
}

// The XML block of a fit is an entry of a scene's list Materials and reads back to the same bits, words and flags
// included.
TEST(Report, MaterialReadsBack) {
  for (const std::string law : {"itskov", "rebar"}) {
    const FitFolder folder;
    folder.measure({tensile[0]}, 0.02);
    folder.write_fit(
        parameter("type", "string", law) + parameter("set", "string", "pantyhose") +
            (law == "rebar" ? parameter("modulus", "string", "secant") : parameter("swap axes", "bool", "true")),
        free_parameter(law == "rebar" ? "C10" : "mu1", 1e-3, 0.7), "", {tensile[0]}, "");
    const FitProblem problem(folder.read());
    const std::vector<double> params = problem.params({1.0 / 3.0});
    folder.write("materials.xml", list("Materials", material_xml(problem, params)));
    const base::List materials =
        base::read_xml(folder.path("materials.xml"), base::Spec("Materials", "").entries(material::material_spec()));
    const material::Material read(materials.entries().front());
    EXPECT_EQ(read.name(), "knit");
    EXPECT_EQ(read.law().name, law);
    EXPECT_EQ(read.params(), params) << law;
  }
}

// The report tells what limits the trust in a fit: a curve that is only predicted and by how much it is off, a
// parameter at its bound, what the data leave open.
TEST(Report, TellsTheLimits) {
  const FitFolder folder;
  std::vector<VirtualTest> tests = {tensile[0], tensile[2]};
  tests[1].weight = 0.0;
  folder.measure(tests, 0.02);
  folder.write_fit(parameter("type", "string", "rebar") + parameter("C10", "double", "0.008"),
                   free_parameter("c0", 0.0, 1e-3) + free_parameter("d0", 0.1, 1.0), "", tests,
                   parameter("generations", "int", "20") + parameter("starts", "int", "1"));
  const Outcome o = run(folder);
  const std::string text = report_text(o.problem, o.result, o.reports, parameter_statistics(o.problem, o.result));
  EXPECT_THAT(text, HasSubstr("bias (predicted, not fitted): rms "));
  EXPECT_THAT(text, HasSubstr("at the largest stretch "));
  EXPECT_THAT(text, HasSubstr("c0 = 0.001 MPa, held by its upper bound\n"));
  EXPECT_THAT(text, HasSubstr("The data do not determine the deviation of a parameter that is held"));
  EXPECT_THAT(text, HasSubstr("the law does not follow these curves"));
  EXPECT_THAT(text, HasSubstr("  1 d0: no curve depends on it"));
}

}  // namespace
}  // namespace toile::identify::test
