#include "toile/identify/calibrated_range.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "fabric_tests.hpp"
#include "toile/identify/curve_models.hpp"
#include "toile/identify/report.hpp"

namespace toile::identify::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string rebar = parameter("type", "string", "rebar") + parameter("set", "string", "pantyhose");
const std::string mu = free_parameter("C10", 1e-3, 1.0);

/// A strip of the rebar fabric along wale and course; a third curve is only predicted.
FitProblem problem(const FitFolder& folder, const std::string& more = "", const std::string& free = mu) {
  const std::vector<VirtualTest> tests = {
      {"wale", "uniaxial", 0.0, 1.5}, {"course", "uniaxial", 90.0, 1.8}, {"predicted", "uniaxial", 90.0, 2.5, 0.0}};
  folder.measure(tests, 0.0);
  folder.write_fit(rebar + more, free, "", tests, "");
  return FitProblem(folder.read());
}

std::vector<double> stresses(const FitProblem& fit, const std::vector<double>& params) {
  std::vector<Curve> fitted(fit.curves().begin(), fit.curves().end() - 1);
  const auto model = forward_model(fitted);
  std::vector<double> stress(static_cast<std::size_t>(model->size()));
  EXPECT_EQ(model->stress(fit.law(), params.data(), stress.data()), 0);
  return stress;
}

// The range ends at the largest fibre strain of the fitted data, ln 1.8 here, and the law stays the same, bit for bit,
// at every fitted point. Predicted curves do not count.
TEST(CalibratedRange, EndsWhereTheDataEnd) {
  const FitFolder folder;
  const FitProblem fit = problem(folder);
  const std::vector<double> params = fit.params({0.5});
  const CalibratedRange range = calibrated_range(fit, params);
  EXPECT_TRUE(range.is_set);
  EXPECT_NEAR(range.largest_wale, 1.5, 1e-12);
  EXPECT_NEAR(range.largest_course, 1.8, 1e-12);
  const double end = range.params[static_cast<std::size_t>(fit.index_of("calibrated strain"))];
  EXPECT_GE(end, std::log(1.8));
  EXPECT_LE(end, std::log(1.8) + 1.1e-4);
  EXPECT_EQ(stresses(fit, range.params), stresses(fit, params));
  EXPECT_THAT(material_xml(fit, range.params), HasSubstr("name=\"calibrated strain\" type=\"double\" value=\"0.5878"));
  EXPECT_THAT(range_text(range),
              HasSubstr("to 1.5 along the wale, to 1.8 along the course; \"calibrated strain\" ends"));
}

// A value of the fit file stays, whether it is larger or smaller than what the data reach, and so does one that is
// found.
TEST(CalibratedRange, AGivenValueStays) {
  for (const std::string value : {"0.3", "2"}) {
    const FitFolder folder;
    const FitProblem fit = problem(folder, parameter("calibrated strain", "double", value));
    const CalibratedRange range = calibrated_range(fit, fit.params({0.5}));
    EXPECT_FALSE(range.is_set);
    EXPECT_EQ(range.params, fit.params({0.5}));
  }
  const FitFolder folder;
  const FitProblem fit = problem(folder, "", mu + free_parameter("calibrated strain", 0.1, 2.0));
  EXPECT_EQ(calibrated_range(fit, fit.params({0.5, 0.5})).params, fit.params({0.5, 0.5}));
}

// A law without such a parameter is left as it is; the report names the range of its data.
TEST(CalibratedRange, OfOtherLaws) {
  const FitFolder folder;
  const std::vector<VirtualTest> tests = {{"bias", "uniaxial", 45.0, 1.4}};
  folder.measure(tests, 0.0);
  folder.write_fit(parameter("type", "string", "neo-hookean"), mu, "", tests, "");
  const FitProblem fit(folder.read());
  const CalibratedRange range = calibrated_range(fit, fit.params({0.5}));
  EXPECT_FALSE(range.is_set);
  EXPECT_EQ(range.params, fit.params({0.5}));
  // An isotropic strip has C11 = C22 = (l^2 + 1/l)/2 at 45 degrees.
  EXPECT_NEAR(range.largest_wale, std::sqrt(0.5 * (1.4 * 1.4 + 1.0 / 1.4)), 1e-9);
  EXPECT_NEAR(range.largest_course, range.largest_wale, 1e-9);
  EXPECT_THAT(range_text(range), Not(HasSubstr("calibrated strain")));
}

// What a run is told of: each direction as far as it was tested, fabric at rest counting as tested. The curve of a law
// that is the same along both tests both.
TEST(CalibratedRange, OfEachDirection) {
  const auto limits = [](const std::string& material, const std::string& free, const std::string& name) {
    const FitFolder folder;
    const std::vector<VirtualTest> tests = {{"wale", "uniaxial", 0.0, 1.5}};
    folder.measure(tests, 0.0);
    folder.write_fit(material, free, "", tests, "");
    const FitProblem fit(folder.read());
    ParameterStatistics statistics;
    statistics.open = {true};
    const material::FitLimits all = fit_limits(fit, statistics, calibrated_range(fit, fit.params({0.5})));
    EXPECT_THAT(all.undetermined, ::testing::ElementsAre(name));
    return std::pair(all.wale, all.course);
  };
  const auto [wale, course] = limits(rebar, mu, "C10");
  EXPECT_NEAR(wale, 1.5, 1e-12);
  EXPECT_EQ(course, 1.0);
  const auto [one, other] = limits(parameter("type", "string", "neo-hookean"), mu, "C10");
  EXPECT_NEAR(one, 1.5, 1e-12);
  EXPECT_EQ(other, one);
}

}  // namespace
}  // namespace toile::identify::test
