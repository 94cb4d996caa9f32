#include <algorithm>
#include <cmath>
#include <limits>

#include "toile/identify/curve_models.hpp"
#include "toile/identify/statistics.hpp"

namespace toile::identify {
namespace {

CurveReport report(const Curve& curve, std::vector<double> stress) {
  CurveReport r = {curve.name, curve.weight > 0.0, std::move(stress), 0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  double data = 0.0, largest_stress = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < curve.stress.size(); ++i) {
    const double d = r.stress[i] - curve.stress[i];
    largest_stress = std::max(largest_stress, std::abs(curve.stress[i]));
    if (!std::isfinite(d)) {
      ++r.missing;
      continue;
    }
    data += curve.stress[i] * curve.stress[i];
    sum += d * d;
    if (std::abs(d) < std::abs(r.largest)) continue;
    r.largest = d;
    r.largest_at = curve.stretch[i];
  }
  const auto n = static_cast<double>(curve.stress.size()) - r.missing;
  r.rms = std::sqrt(sum / n);
  r.relative = std::sqrt(sum / data);
  r.largest_relative = r.largest / largest_stress;
  r.end_relative = r.stress.back() / curve.stress.back() - 1.0;
  return r;
}

std::vector<double> stress_of(const Curve& curve, const FitProblem& problem, const std::vector<double>& params,
                              Fidelity fidelity = Fidelity::as_asked) {
  std::vector<double> stress(curve.stretch.size());
  forward_model({curve}, fidelity)->stress(problem.law(), params.data(), stress.data());
  return stress;
}

/// Largest difference over the largest of `stress`; NaN if one is missing.
double largest_difference(const std::vector<double>& other, const std::vector<double>& stress) {
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double difference = other[i] - stress[i];
    if (!std::isfinite(difference)) return std::numeric_limits<double>::quiet_NaN();
    largest = std::max(largest, std::abs(difference));
    scale = std::max(scale, std::abs(stress[i]));
  }
  return largest / scale;
}

/// `stress` of the strip.
StripReport strip_report(const Curve& curve, const FitProblem& problem, const std::vector<double>& params,
                         const std::vector<double>& stress) {
  // Of a second-order error a mesh twice as fine removes three quarters.
  constexpr double extrapolation = 4.0 / 3.0;
  Curve fine = curve;
  fine.strip->elements_across *= 2;
  const std::vector<double> homogeneous = stress_of(curve, problem, params, Fidelity::homogeneous);
  return {curve.strip->elements_across, curve.strip->elements_along(),
          extrapolation * largest_difference(stress_of(fine, problem, params), stress),
          homogeneous.back() / stress.back() - 1.0};
}

}  // namespace

std::vector<CurveReport> curve_reports(const FitProblem& problem, const std::vector<double>& params) {
  std::vector<CurveReport> all;
  for (const Curve& curve : problem.curves()) {
    all.push_back(report(curve, stress_of(curve, problem, params)));
    if (curve.strip) all.back().strip = strip_report(curve, problem, params, all.back().stress);
  }
  return all;
}

}  // namespace toile::identify
