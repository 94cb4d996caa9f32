#include "toile/identify/clamped_strip.hpp"

#include <iostream>
#include <memory>

#include "material/evaluation.hpp"
#include "strip_references.hpp"
#include "toile/identify/homogeneous.hpp"

namespace toile::identify::test {
namespace {

using material::test::law;
using material::test::values;

const double degree = std::acos(-1.0) / 180.0;
constexpr int default_across = 12;

std::vector<double> strip_stress(const StripReference& r, int across, double length = 150.0) {
  std::vector<double> P(r.stretch.size());
  const std::vector<double> params = values(r.material, "pantyhose");
  ClampedStrip strip({length, 50.0, across}, r.angle * degree, r.stretch);
  EXPECT_EQ(strip.stress(law(r.material), params.data(), P.data()), 0) << r.material << " " << r.angle;
  return P;
}

std::vector<double> homogeneous_stress(const StripReference& r) {
  std::vector<TestPoint> points;
  for (const double l : r.stretch) points.push_back({TestKind::uniaxial, r.angle * degree, l});
  std::vector<double> P(points.size());
  Homogeneous(points).stress(law(r.material), values(r.material, "pantyhose").data(), P.data());
  return P;
}

double largest_relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] / b[i] - 1.0));
  return largest;
}

// With the default mesh the stress of every fabric, pulled along wale, course and in between, is that of the
// independent solution within 0.3 %, at every stretch; that of a homogeneous state is not.
TEST(ClampedStrip, AgreesWithTheIndependentSolution) {
  const std::vector<StripReference> all = strip_references();
  ASSERT_EQ(all.size(), 7u);
  for (const StripReference& r : all) {
    const double error = largest_relative_difference(strip_stress(r, default_across), r.stress);
    const double homogeneous = largest_relative_difference(homogeneous_stress(r), r.stress);
    std::cout << r.material << ", " << r.angle << " deg: off by " << 100.0 * error << " %, a homogeneous state by "
              << 100.0 * homogeneous << " %\n";
    EXPECT_LT(error, 0.003) << r.material << " " << r.angle;
    EXPECT_GT(homogeneous, 0.007) << r.material << " " << r.angle;
  }
}

// From the default mesh on the stress converges with the second power of the element size to the independent solution.
TEST(ClampedStrip, ConvergesWithSecondOrder) {
  for (const StripReference& r : strip_references()) {
    double error[2];
    for (int level = 0; level < 2; ++level) {
      error[level] = largest_relative_difference(strip_stress(r, default_across << level), r.stress);
      std::cout << r.material << ", " << r.angle << " deg, " << (default_across << level)
                << " across: " << 100.0 * error[level] << " %\n";
    }
    EXPECT_GE(std::log2(error[0] / error[1]), 0.95 * 2.0) << r.material << " " << r.angle;
  }
}

/// Stresses of the strips of one law at several angles, one after the other, and their gradients by its parameters.
struct Strips {
  explicit Strips(const material::LawV1& of) : fabric(of) {
    for (const double angle : {0.0, 90.0, 30.0})
      strips.push_back(std::make_unique<ClampedStrip>(StripSpecimen{100.0, 50.0, 6}, angle * degree, stretches));
  }

  std::vector<double> stress(const std::vector<double>& params) {
    std::vector<double> all;
    for (auto& strip : strips) {
      std::vector<double> P(stretches.size());
      EXPECT_EQ(strip->stress(fabric, params.data(), P.data()), 0);
      all.insert(all.end(), P.begin(), P.end());
    }
    return all;
  }
  /// By one parameter.
  std::vector<double> gradient(const std::vector<double>& params, std::size_t k) {
    std::vector<double> all;
    for (auto& strip : strips) {
      const std::size_t n = stretches.size();
      std::vector<double> P(n), gradient(n * params.size());
      EXPECT_EQ(strip->stress_and_gradient(fabric, params.data(), P.data(), gradient.data()), 0);
      all.insert(all.end(), &gradient[k * n], &gradient[k * n] + n);
    }
    return all;
  }

  const material::LawV1& fabric;
  const std::vector<double> stretches = {1.1, 1.4, 1.7};
  std::vector<std::unique_ptr<ClampedStrip>> strips;
};

// The derivatives of the stress by every parameter are those of central differences of the whole solution, and none of
// a parameter that is a number is zero at all points.
TEST(ClampedStrip, SensitivitiesAreDifferences) {
  for (const std::string name : {"itskov", "rebar", "neo-hookean"}) {
    const material::LawV1& fabric = law(name);
    std::vector<double> params = values(name, "pantyhose");
    Strips strips(fabric);
    for (std::size_t k = 0; k < params.size(); ++k) {
      if (fabric.info[k].choices != nullptr || std::string(fabric.info[k].name) == "calibrated strain") continue;
      const std::vector<double> gradient = strips.gradient(params, k);
      const double value = params[k], h = 1e-5 * std::max(std::abs(value), 1e-3);
      params[k] = value + h;
      const std::vector<double> high = strips.stress(params);
      params[k] = value - h;
      const std::vector<double> low = strips.stress(params);
      params[k] = value;
      double largest = 0.0;
      for (const double g : gradient) largest = std::max(largest, std::abs(g));
      EXPECT_GT(largest, 0.0) << name << " " << fabric.info[k].name;
      for (std::size_t i = 0; i < gradient.size(); ++i)
        EXPECT_NEAR(gradient[i], (high[i] - low[i]) / (2.0 * h), 2e-6 * largest)
            << name << " " << fabric.info[k].name << " point " << i;
    }
  }
}

// The longer the strip the nearer its stress is to that of a homogeneous state: the difference falls as 1 / length.
TEST(ClampedStrip, LongStripsAreHomogeneous) {
  for (const StripReference& r : strip_references()) {
    const std::vector<double> limit = homogeneous_stress(r);
    const double at_10 = largest_relative_difference(strip_stress(r, default_across, 10 * 50.0), limit);
    const double at_40 = largest_relative_difference(strip_stress(r, default_across, 40 * 50.0), limit);
    EXPECT_NEAR(at_40, at_10 / 4.0, 0.1 * at_10 / 4.0) << r.material << " " << r.angle;
  }
}

// From the first stretch on at which a strip would buckle in its plane there is no number, whatever comes after; what
// is before is as it was.
TEST(ClampedStrip, HasNoNumberBeyondWhatItCanReach) {
  const material::LawV1& fabric = law("neo-hookean");
  const std::vector<double> params = values("neo-hookean", "pantyhose");
  const StripSpecimen slender = {500.0, 50.0, 6};
  std::vector<double> P(4), gradient(4 * params.size()), alone(1);
  ClampedStrip strip(slender, 0.0, {0.99, 0.9, 0.89, 0.88});
  EXPECT_EQ(strip.stress_and_gradient(fabric, params.data(), P.data(), gradient.data()), 3);
  ClampedStrip(slender, 0.0, {0.99}).stress(fabric, params.data(), alone.data());
  EXPECT_LT(P[0], 0.0);
  EXPECT_EQ(P[0], alone[0]);
  EXPECT_TRUE(std::isfinite(gradient[0]));
  for (const int i : {1, 2, 3}) {
    EXPECT_TRUE(std::isnan(P[i])) << i;
    EXPECT_TRUE(std::isnan(gradient[i])) << i;
  }
}

// Stiff laws are followed from rest to one large stretch: exponents of 20, at any angle.
TEST(ClampedStrip, StiffLaws) {
  std::vector<double> params = values("itskov", "pantyhose");
  for (const int exponent : {1, 2, 6, 7, 11, 12}) params[exponent] = 20.0;
  for (const double angle : {0.0, 30.0, 45.0, 90.0}) {
    double P = 0.0;
    ClampedStrip strip({100.0, 50.0, 8}, angle * degree, {1.8});
    EXPECT_EQ(strip.stress(law("itskov"), params.data(), &P), 0) << angle;
    EXPECT_GT(P, 0.0) << angle;
  }
}

}  // namespace
}  // namespace toile::identify::test
