#include "toile/identify/calibrated_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "toile/identify/homogeneous.hpp"

namespace toile::identify {
namespace {

constexpr const char* parameter_name = "calibrated strain";

/// C of the states of all fitted points that have one: [3][n], in the axes of the fabric.
std::vector<double> fitted_states(const FitProblem& problem, const std::vector<double>& params) {
  std::vector<TestPoint> points;
  for (const Curve& curve : problem.curves())
    if (curve.weight > 0.0)
      for (const TestPoint& point : curve.points()) points.push_back(point);
  Homogeneous model(points);
  std::vector<double> stress(points.size());
  model.stress(problem.law(), params.data(), stress.data());
  std::vector<double> c11, c22, c12;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(stress[i])) continue;
    const double c = std::cos(points[i].angle), s = std::sin(points[i].angle);
    const double l = points[i].stretch, k = model.shear()[i], m = model.lateral()[i];
    const double xx = l * l, yy = k * k + m * m, xy = l * k;
    c11.push_back(c * c * xx + s * s * yy + 2.0 * c * s * xy);
    c22.push_back(s * s * xx + c * c * yy - 2.0 * c * s * xy);
    c12.push_back(c * s * (yy - xx) + (c * c - s * s) * xy);
  }
  std::vector<double> all = c11;
  all.insert(all.end(), c22.begin(), c22.end());
  all.insert(all.end(), c12.begin(), c12.end());
  return all;
}

/// Energies [n] of states [3][n].
std::vector<double> energies(const material::LawV1& law, const std::vector<double>& C,
                             const std::vector<double>& params) {
  const std::size_t n = C.size() / 3;
  std::vector<double> W(n), S(C.size()), thickness(n);
  std::vector<std::uint8_t> status(n);
  law.evaluate(law.context, static_cast<int>(n), C.data(), params.data(), 0, W.data(), S.data(), nullptr,
               thickness.data(), nullptr, status.data());
  return W;
}

/// Whether wale and course can be exchanged in all states [3][n].
bool is_same_along_both(const material::LawV1& law, const std::vector<double>& C, const std::vector<double>& params) {
  constexpr double same = 1e-9;  // of the energy
  std::vector<double> exchanged = C;
  std::swap_ranges(exchanged.begin(), exchanged.begin() + static_cast<long>(C.size() / 3),
                   exchanged.begin() + static_cast<long>(C.size() / 3));
  const std::vector<double> one = energies(law, C, params), other = energies(law, exchanged, params);
  for (std::size_t i = 0; i < one.size(); ++i)
    if (!(std::abs(one[i] - other[i]) <= same * std::abs(one[i]))) return false;
  return true;
}

/// Number of states that the law says it is continued at.
long extrapolated(const material::LawV1& law, const std::vector<double>& C, const std::vector<double>& params) {
  const int n = static_cast<int>(C.size() / 3);
  std::vector<double> W(C.size() / 3), S(C.size()), thickness(C.size() / 3);
  std::vector<std::uint8_t> status(C.size() / 3);
  law.evaluate(law.context, n, C.data(), params.data(), 0, W.data(), S.data(), nullptr, thickness.data(), nullptr,
               status.data());
  return std::count(status.begin(), status.end(), static_cast<std::uint8_t>(material::point_extrapolated));
}

}  // namespace

CalibratedRange calibrated_range(const FitProblem& problem, const std::vector<double>& params) {
  constexpr double grain = 1e-4;
  const std::vector<double> C = fitted_states(problem, params);
  const std::size_t n = C.size() / 3;
  CalibratedRange range;
  range.params = params;
  if (n == 0) return range;
  range.largest_wale = std::sqrt(*std::max_element(C.begin(), C.begin() + static_cast<long>(n)));
  range.largest_course =
      std::sqrt(*std::max_element(C.begin() + static_cast<long>(n), C.begin() + static_cast<long>(2 * n)));
  range.tests_both = is_same_along_both(problem.law(), C, params);
  const int index = problem.index_of(parameter_name);
  if (index < 0 || problem.prescribes(index)) return range;
  double& end = range.params[static_cast<std::size_t>(index)];
  const double before = end;
  const long least = extrapolated(problem.law(), C, range.params);
  double below = 0.0, enough = before;
  while (enough - below > 0.01 * grain) {
    end = 0.5 * (below + enough);
    (extrapolated(problem.law(), C, range.params) > least ? below : enough) = end;
  }
  end = std::min(before, std::max(grain, grain * std::ceil(enough / grain)));
  range.is_set = end < before;
  return range;
}

material::FitLimits fit_limits(const FitProblem& problem, const ParameterStatistics& statistics,
                               const CalibratedRange& range) {
  material::FitLimits limits;
  limits.undetermined = problem.left_open();
  for (std::size_t k = 0; k < problem.free().size(); ++k)
    if (statistics.open[k]) limits.undetermined.emplace_back(problem.law().info[problem.free()[k].index].name);
  const double larger = std::max(range.largest_wale, range.largest_course);
  limits.wale = std::max(1.0, range.tests_both ? larger : range.largest_wale);
  limits.course = std::max(1.0, range.tests_both ? larger : range.largest_course);
  return limits;
}

std::string range_text(const CalibratedRange& range) {
  std::ostringstream text;
  text.precision(4);
  text << "Range of the fitted data: fibre stretch to " << range.largest_wale << " along the wale, to "
       << range.largest_course << " along the course" << (range.is_set ? "; \"calibrated strain\" ends there" : "")
       << "\n";
  return text.str();
}

}  // namespace toile::identify
