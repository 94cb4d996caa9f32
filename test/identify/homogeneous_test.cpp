#include "toile/identify/homogeneous.hpp"

#include <fstream>
#include <map>
#include <sstream>

#include "material/evaluation.hpp"

namespace toile::identify::test {
namespace {

using material::test::law;
using material::test::values;

const double degree = std::acos(-1.0) / 180.0;

std::vector<double> stresses(const std::string& name, const std::vector<double>& params,
                             const std::vector<TestPoint>& points) {
  std::vector<double> stress(points.size());
  EXPECT_EQ(Homogeneous(points).stress(law(name), params.data(), stress.data()), 0);
  return stress;
}

// Neo-Hookean fabric: uniaxial P = mu (l - 1/l^2) at every angle, equibiaxial mu (l - 1/l^5), strip-biaxial
// mu (l - 1/l^3).
TEST(Homogeneous, NeoHookeanIsAnalytic) {
  const std::vector<double> params = values("neo-hookean", "pantyhose");
  const double mu = 2.0 * params[0];
  for (const double angle : {0.0, 30.0, 45.0, 90.0, 135.0})
    for (const double l : {0.6, 0.9, 1.0, 1.2, 2.0, 4.0}) {
      const double a = angle * degree;
      const std::vector<double> P =
          stresses("neo-hookean", params,
                   {{TestKind::uniaxial, a, l}, {TestKind::equibiaxial, a, l}, {TestKind::strip_biaxial, a, l}});
      EXPECT_NEAR(P[0], mu * (l - std::pow(l, -2.0)), 1e-13) << angle << " " << l;
      EXPECT_NEAR(P[1], mu * (l - std::pow(l, -5.0)), 1e-13) << angle << " " << l;
      EXPECT_NEAR(P[2], mu * (l - std::pow(l, -3.0)), 1e-13) << angle << " " << l;
    }
}

using Columns = std::map<std::string, std::vector<double>>;

/// Columns of test/data/plane_stress/homogeneous_<name>.csv by their titles.
Columns reference_columns(const std::string& name) {
  std::ifstream file(TOILE_SOURCE_DIR "/test/data/plane_stress/homogeneous_" + name + ".csv");
  Columns columns;
  std::vector<std::string> titles;
  for (std::string line, cell; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i)
      if (std::isalpha(static_cast<unsigned char>(cell[0])))
        titles.push_back(cell);
      else
        columns[titles[i]].push_back(std::stod(cell));
  }
  return columns;
}

// The states of every kind of test are those of the independent reference (1e-10 of the largest stress), for a law
// with coupling and one with fibres.
TEST(Homogeneous, States) {
  const std::map<std::string, TestPoint> tests = {{"uni_wale_P", {TestKind::uniaxial, 0.0, 1.0}},
                                                  {"uni_course_P", {TestKind::uniaxial, 90.0 * degree, 1.0}},
                                                  {"bias45_P", {TestKind::uniaxial, 45.0 * degree, 1.0}},
                                                  {"equi_P_wale", {TestKind::equibiaxial, 0.0, 1.0}},
                                                  {"equi_P_course", {TestKind::equibiaxial, 90.0 * degree, 1.0}},
                                                  {"ps_wale_P", {TestKind::strip_biaxial, 0.0, 1.0}},
                                                  {"ps_course_P", {TestKind::strip_biaxial, 90.0 * degree, 1.0}}};
  for (const std::string name : {"itskov", "rebar"}) {
    const Columns reference = reference_columns(name);
    for (const auto& [title, test] : tests) {
      std::vector<TestPoint> points;
      for (const double l : reference.at("stretch")) points.push_back({test.kind, test.angle, l});
      const std::vector<double> P = stresses(name, values(name, "pantyhose"), points);
      const std::vector<double>& expected = reference.at(title);
      ASSERT_GT(expected.size(), 10u);
      const double scale = *std::max_element(expected.begin(), expected.end());
      for (std::size_t i = 0; i < P.size(); ++i)
        EXPECT_NEAR(P[i], expected[i], 1e-10 * scale) << name << " " << title << " row " << i;
    }
  }
}

std::vector<TestPoint> mixed_points() {
  std::vector<TestPoint> points;
  for (const double angle : {0.0, 90.0, 45.0, 20.0})
    for (const TestKind kind : {TestKind::uniaxial, TestKind::equibiaxial, TestKind::strip_biaxial})
      for (const double l : {1.05, 1.3, 1.9}) points.push_back({kind, angle * degree, l});
  return points;
}

// The derivatives of the stress with respect to every parameter are those of central differences of the whole
// solution, and none of a parameter that is a number is zero at all points.
TEST(Homogeneous, SensitivitiesAreDifferences) {
  for (const std::string name : {"itskov", "rebar", "neo-hookean"}) {
    const material::LawV1& fabric = law(name);
    std::vector<double> params = values(name, "pantyhose");
    const std::vector<TestPoint> points = mixed_points();
    const std::size_t n = points.size();
    Homogeneous states(points);
    std::vector<double> P(n), gradient(n * params.size()), high(n), low(n);
    ASSERT_EQ(states.stress_and_gradient(fabric, params.data(), P.data(), gradient.data()), 0);
    for (std::size_t k = 0; k < params.size(); ++k) {
      if (fabric.info[k].choices != nullptr || std::string(fabric.info[k].name) == "calibrated strain") continue;
      const double value = params[k], h = 1e-5 * std::max(std::abs(value), 1e-3);
      params[k] = value + h;
      states.stress(fabric, params.data(), high.data());
      params[k] = value - h;
      states.stress(fabric, params.data(), low.data());
      params[k] = value;
      double largest = 0.0;
      for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(gradient[k * n + i]));
      EXPECT_GT(largest, 0.0) << name << " " << fabric.info[k].name;
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(gradient[k * n + i], (high[i] - low[i]) / (2.0 * h), 2e-6 * largest)
            << name << " " << fabric.info[k].name << " point " << i;
    }
  }
}

// A point has the same stress, to the last bit, alone and among others.
TEST(Homogeneous, PointsAreIndependent) {
  const std::vector<double> params = values("itskov", "pantyhose");
  const std::vector<double> together = stresses("itskov", params, mixed_points());
  for (std::size_t i = 0; i < together.size(); ++i)
    EXPECT_EQ(stresses("itskov", params, {mixed_points()[i]})[0], together[i]) << i;
}

// A state that the law does not admit is not a number, and is counted.
TEST(Homogeneous, RefusesWhatIsNotAdmissible) {
  const std::vector<double> params = values("itskov", "pantyhose");
  std::vector<double> P(2);
  Homogeneous states({{TestKind::equibiaxial, 0.0, 0.01}, {TestKind::equibiaxial, 0.0, 1.1}});
  EXPECT_EQ(states.stress(law("itskov"), params.data(), P.data()), 1);
  EXPECT_TRUE(std::isnan(P[0]));
  EXPECT_GT(P[1], 0.0);
}

// Newton's method finds the uniaxial states of stiff laws: exponents of 20, stretches from 0.4 to 4, at any angle.
TEST(Homogeneous, StiffLaws) {
  std::vector<double> params = values("itskov", "pantyhose");
  for (const int exponent : {1, 2, 6, 7, 11, 12}) params[exponent] = 20.0;
  std::vector<TestPoint> points;
  for (const double angle : {0.0, 15.0, 45.0, 70.0, 90.0})
    for (double l = 0.4; l <= 4.0; l += 0.1) points.push_back({TestKind::uniaxial, angle * degree, l});
  for (const double P : stresses("itskov", params, points)) EXPECT_TRUE(std::isfinite(P));
}

}  // namespace
}  // namespace toile::identify::test
