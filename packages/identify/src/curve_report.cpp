#include <cmath>

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

}  // namespace

std::vector<CurveReport> curve_reports(const FitProblem& problem, const std::vector<double>& params) {
  std::vector<CurveReport> all;
  for (const Curve& curve : problem.curves()) {
    std::vector<double> stress(curve.stress.size());
    forward_model({curve})->stress(problem.law(), params.data(), stress.data());
    all.push_back(report(curve, std::move(stress)));
  }
  return all;
}

}  // namespace toile::identify
