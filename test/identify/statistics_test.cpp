#include "toile/identify/statistics.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "fabric_tests.hpp"
#include "toile/identify/report.hpp"

namespace toile::identify::test {
namespace {

using ::testing::HasSubstr;

/// A fit that is linear in its parameters: W = a (I1 - 3) + b (l1 - 1)^2, whose uniaxial stress along the wale is
/// P = 2 a (l - 1/l^2) + 2 b (l - 1).
class LinearFit {
 public:
  /// `least`: bound of b; `constraints`: of the fit file. The data are `a`, `b` and a disturbance that no a, b follow.
  LinearFit(double a, double b, double least, const std::string& constraints) {
    std::string rows = "stretch [-], nominal stress [MPa]\n";
    for (int i = 1; i <= points; ++i) {
      const double l = 1.0 + 0.1 * i;
      stretch_.push_back(l);
      stress_.push_back(a * by_a(l) + b * by_b(l) + 0.02 * (i % 3 - 1));
      rows += std::to_string(l) + ", " + std::to_string(stress_.back()) + "\n";
    }
    folder_.write("wale.csv", rows);
    folder_.write_fit(
        parameter("type", "string", "linear"), free_parameter("a", 0.0, 5.0) + free_parameter("b", least, 5.0),
        constraints, {{"wale", "uniaxial", 0.0, 2.0}},
        parameter("starts", "int", "1") + parameter("generations", "int", "50"),
        list("Formulas",
             list("linear", parameter("energy", "string", "a*(I1 - 3) + b*(l1 - 1)^2") +
                                list("Parameters", list("a", parameter("unit", "string", "MPa")) + list("b", "")))));
    input_.emplace(folder_.read());
    problem_.emplace(*input_, folder_.laws());
    result_ = fit(*problem_, Algorithm(input_->list("Algorithm")), [](const FitStatus&) {});
    statistics_ = parameter_statistics(*problem_, result_);
  }

  const FitProblem& problem() const { return *problem_; }
  const FitResult& result() const { return result_; }
  const ParameterStatistics& statistics() const { return statistics_; }
  std::string report() const {
    return report_text(*problem_, result_, curve_reports(*problem_, result_.params), statistics_);
  }

  /// sum_i (u . dP_i)(v . dP_i) / sigma_i^2 with dP_i the derivatives by a and b.
  double information(const std::array<double, 2>& u, const std::array<double, 2>& v) const {
    const std::vector<double>& sigma = problem_->curves()[0].deviation;
    double sum = 0.0;
    for (std::size_t i = 0; i < stretch_.size(); ++i) {
      const double l = stretch_[i], first = u[0] * by_a(l) + u[1] * by_b(l), second = v[0] * by_a(l) + v[1] * by_b(l);
      sum += first * second / (sigma[i] * sigma[i]);
    }
    return sum;
  }
  /// chi^2 over the degrees of freedom that `parameters` leave.
  double variance(int parameters) const { return result_.chi_squared / (points - parameters); }

 private:
  static constexpr int points = 12;
  static double by_a(double l) { return 2.0 * (l - 1.0 / (l * l)); }
  static double by_b(double l) { return 2.0 * (l - 1.0); }

  FitFolder folder_;
  std::vector<double> stretch_, stress_;
  std::optional<base::List> input_;
  std::optional<FitProblem> problem_;
  FitResult result_;
  ParameterStatistics statistics_;
};

// Inside of every bound, the covariance is s^2 times the inverse of the 2 x 2 information matrix.
TEST(Statistics, FreeParameters) {
  const LinearFit fit(1.0, 0.5, -5.0, "");
  const ParameterStatistics& s = fit.statistics();
  const double aa = fit.information({1, 0}, {1, 0}), ab = fit.information({1, 0}, {0, 1}),
               bb = fit.information({0, 1}, {0, 1}), factor = fit.variance(2) / (aa * bb - ab * ab);
  const double expected[] = {factor * bb, -factor * ab, -factor * ab, factor * aa};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(s.covariance[i], expected[i], 1e-6 * std::abs(expected[i])) << i;
  EXPECT_NEAR(s.deviation[1], std::sqrt(expected[3]), 1e-6 * s.deviation[1]);
  EXPECT_THAT(s.held, ::testing::ElementsAre(false, false));
  EXPECT_TRUE(s.active_conditions.empty());
}

// b on its lower bound is held: the variance of a is that of a fit of a alone, much less than beside a free b, and the
// report says that the data do not determine the deviation of b.
TEST(Statistics, ParameterOnItsBound) {
  const LinearFit fit(1.0, -0.5, 0.0, "");
  const ParameterStatistics& s = fit.statistics();
  ASSERT_EQ(s.at_bound[1], -1);
  const double expected = fit.variance(1) / fit.information({1, 0}, {1, 0});
  EXPECT_NEAR(s.deviation[0], std::sqrt(expected), 1e-6 * s.deviation[0]);
  EXPECT_TRUE(std::isnan(s.deviation[1]));
  EXPECT_NEAR(s.covariance[0], expected, 1e-6 * expected);
  for (int i = 1; i < 4; ++i) EXPECT_TRUE(std::isnan(s.covariance[i])) << i;
  EXPECT_THAT(s.held, ::testing::ElementsAre(false, true));
  EXPECT_EQ(s.combinations.size(), 1u);
  EXPECT_THAT(fit.report(), HasSubstr(", held by its lower bound\n"));
  EXPECT_THAT(fit.report(), HasSubstr("The data do not determine the deviation of a parameter that is held"));
}

// On the edge of a + 2 b <= 1.5 only the direction (2, -1) is free: along it the covariance is that of a fit of one
// parameter, and across it there is none.
TEST(Statistics, ActiveCondition) {
  const LinearFit fit(
      1.0, 0.5, -5.0,
      list("sum", parameter("parameters", "Array(string)", "{a, b}") + parameter("factors", "Array(double)", "{1, 2}") +
                      parameter("at most", "double", "1.5")));
  const ParameterStatistics& s = fit.statistics();
  ASSERT_NEAR(fit.result().params[0] + 2.0 * fit.result().params[1], 1.5, 1e-6);
  EXPECT_THAT(s.active_conditions, ::testing::ElementsAre("sum"));
  const double along = fit.variance(1) / fit.information({2, -1}, {2, -1});
  const double expected[] = {4.0 * along, -2.0 * along, -2.0 * along, along};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(s.covariance[i], expected[i], 1e-6 * std::abs(expected[i])) << i;
  EXPECT_NEAR(s.correlation[1], -1.0, 1e-9);
  EXPECT_THAT(s.held, ::testing::ElementsAre(false, false));
  EXPECT_THAT(fit.report(), HasSubstr("On the edge of the condition \"sum\""));
}

// A parameter that no curve depends on is open, wherever it stands: inside of its bounds, or on one.
TEST(Statistics, ParameterWithoutEffect) {
  const FitFolder folder;
  const std::vector<VirtualTest> tests = {{"wale", "uniaxial", 0.0, 1.5}};
  folder.measure(tests, 0.0);
  folder.write_fit(parameter("type", "string", "rebar"),
                   free_parameter("C10", 1e-3, 1.0) + free_parameter("c0", -1.0, 1.0) + free_parameter("d0", 0.0, 1.0),
                   "", tests, "");
  const FitProblem problem(folder.read());
  for (const double x : {0.0, 0.4}) {
    FitResult result;
    result.params = problem.params({0.01, 0.6, x});
    result.starts = {{1, 1.0, 1.0, 1.0, {0.01, 0.6, x}}};
    result.chi_squared = 1.0;
    EXPECT_THAT(parameter_statistics(problem, result).open, ::testing::ElementsAre(false, false, true)) << x;
  }
}

// A bound and a condition together leave nothing: both parameters are held, and no combination is open.
TEST(Statistics, NothingLeft) {
  const LinearFit fit(
      1.0, 20.0, 0.0,
      list("a", parameter("parameters", "Array(string)", "{a}") + parameter("at most", "double", "0.1")));
  EXPECT_THAT(fit.statistics().held, ::testing::ElementsAre(true, true));
  EXPECT_TRUE(fit.statistics().combinations.empty());
  EXPECT_TRUE(std::isfinite(fit.statistics().noise));
  EXPECT_THAT(fit.report(), HasSubstr("  a = 0.1 MPa, held by conditions\n"));
}

}  // namespace
}  // namespace toile::identify::test
