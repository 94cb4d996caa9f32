#include "toile/identify/report.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace toile::identify {
namespace {

/// Correlations above this are told.
constexpr double strong_correlation = 0.95;
/// chi^2 of starts that differ by more than this part are of different places.
constexpr double disagreement = 0.01;
/// Residuals that exceed the stated noise by more than this factor are not noise.
constexpr double misfit = 1.5;

std::string percent(double part) {
  std::ostringstream out;
  out << std::showpos << std::setprecision(3) << 100.0 * part << " %";
  return out.str();
}

void write_starts(std::ostream& out, const FitResult& result, bool has_strips) {
  out << "Starts: chi^2 of the search, and after the polish"
      << (has_strips ? ", with homogeneous states in the place of clamped strips\n" : "\n");
  for (std::size_t s = 0; s < result.starts.size(); ++s) {
    const Start& start = result.starts[s];
    out << "  seed " << start.seed << ": " << start.searched << ", " << start.polished
        << (s == result.best ? "  <- the result\n" : "\n");
    if (start.strips)
      out << "    polished with the clamped strips: " << start.strips->before << " before, " << start.strips->after
          << " after\n";
  }
  const auto [least, most] =
      std::minmax_element(result.starts.begin(), result.starts.end(),
                          [](const Start& a, const Start& b) { return a.polished < b.polished; });
  if (most->polished > (1.0 + disagreement) * least->polished)
    out << "  starts do not agree within " << 100.0 * disagreement
        << " %: there may be better parameters; more generations or starts may find them\n";
}

void write_strip(std::ostream& out, const StripReport& strip) {
  out << "    clamped strip of " << strip.across << " x " << strip.along << " elements: ";
  if (std::isfinite(strip.mesh_error))
    out << "they err by " << 100.0 * strip.mesh_error << " % of the largest stress (from a mesh twice as fine)";
  else
    out << "their error is not known, because a mesh twice as fine does not reach every stretch";
  if (std::isfinite(strip.homogeneous))
    out << "; a homogeneous state of the same law would be " << std::abs(100.0 * strip.homogeneous) << " % too "
        << (strip.homogeneous < 0.0 ? "low" : "high") << " at the largest stretch";
  out << "\n";
}

void write_curve(std::ostream& out, const CurveReport& r) {
  out << "  " << r.name << (r.fitted ? " (fitted): " : " (predicted, not fitted): ") << "rms " << r.rms << " MPa, "
      << 100.0 * r.relative << " % of the data's; largest " << percent(r.largest_relative)
      << " of the largest stress, at stretch " << r.largest_at;
  if (std::isfinite(r.end_relative))
    out << "; at the largest stretch " << std::abs(100.0 * r.end_relative) << " % too "
        << (r.end_relative < 0.0 ? "low" : "high");
  if (r.missing > 0) out << "; at " << r.missing << " points the law has no such state";
  out << "\n";
  if (r.strip) write_strip(out, *r.strip);
}

void write_parameters(std::ostream& out, const FitProblem& problem, const FitResult& result,
                      const ParameterStatistics& statistics) {
  out << "Parameters, with their standard deviation\n";
  for (std::size_t k = 0; k < problem.free().size(); ++k) {
    const FreeParameter& p = problem.free()[k];
    const material::ParamInfo& info = problem.law().info[p.index];
    out << "  " << info.name << " = " << result.params[p.index] << (*info.unit ? " " : "") << info.unit;
    if (statistics.at_bound[k] != 0)
      out << ", held by its " << (statistics.at_bound[k] < 0 ? "lower" : "upper") << " bound";
    else if (statistics.held[k])
      out << ", held by conditions";
    else if (std::isfinite(statistics.deviation[k]))
      out << " +- " << statistics.deviation[k];
    else
      out << " +- not determined";
    if (statistics.open[k] && (statistics.at_bound[k] != 0 || statistics.held[k]))
      out << ", and not determined by the data";
    out << "\n";
  }
  const bool any_held = std::count(statistics.held.begin(), statistics.held.end(), true) > 0;
  if (any_held)
    out << "  The data do not determine the deviation of a parameter that is held; the others are for it held\n";
  for (const std::string& name : statistics.at_edge)
    out << "  A small change of " << name
        << " leaves a fitted point without a state: the result lies on that edge, which deviations do not know of\n";
  for (const std::string& name : statistics.active_conditions)
    out << "  On the edge of the condition \"" << name << "\": deviations are along it\n";
}

void write_correlations(std::ostream& out, const FitProblem& problem, const ParameterStatistics& statistics) {
  const std::size_t n = problem.free().size();
  std::ostringstream pairs;
  pairs.precision(3);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const double r = statistics.correlation[a * n + b];
      if (std::abs(r) > strong_correlation)
        pairs << "  " << problem.law().info[problem.free()[b].index].name << " and "
              << problem.law().info[problem.free()[a].index].name << ": " << r << "\n";
    }
  out << "Correlations beyond " << strong_correlation << "\n" << (pairs.str().empty() ? "  none\n" : pairs.str());
}

void write_undetermined(std::ostream& out, const FitProblem& problem, const ParameterStatistics& statistics) {
  out << "Combinations of relative changes that the data do not determine (within " << 100.0 * undetermined << " %)\n";
  bool any = false;
  for (const Combination& combination : statistics.combinations) {
    if (combination.deviation <= undetermined) continue;
    any = true;
    out << "  " << combination_text(problem, combination) << ": ";
    if (std::isfinite(combination.deviation))
      out << "open by " << 100.0 * combination.deviation << " %\n";
    else
      out << "no curve depends on it\n";
  }
  if (!any) out << "  none\n";
}

}  // namespace

std::string report_text(const FitProblem& problem, const FitResult& result, const std::vector<CurveReport>& curves,
                        const ParameterStatistics& statistics) {
  std::ostringstream out;
  out.precision(4);
  write_starts(out, result, problem.fits_strips());
  out << "Curves: fit minus data, each point a homogeneous state unless a line tells of a clamped strip\n";
  for (const CurveReport& r : curves) write_curve(out, r);
  if (!result.falls.empty())
    out << "  the stress does not rise everywhere, as was asked for: it falls to that of " << result.falls << "\n";
  out << "  residuals are " << statistics.noise << " times the noise that the data were said to have"
      << (statistics.noise > misfit ? ": the law does not follow these curves, and the deviations below are too small\n"
                                    : "\n");
  write_parameters(out, problem, result, statistics);
  write_correlations(out, problem, statistics);
  write_undetermined(out, problem, statistics);
  return out.str();
}

}  // namespace toile::identify
