#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/identify/fit.hpp"

namespace toile::identify {

/// What is to be known of a clamped strip at the result; NaN if a state is missing.
struct StripReport {
  int across, along;  ///< elements
  /// Largest, over the largest stress: from a mesh twice as fine, by Richardson's extrapolation.
  double mesh_error;
  double homogeneous;  ///< deviation of a homogeneous state of the same law at the last point, over the stress there
};

/// How a curve and the fit differ. Deviations are fit minus data, over the points where the law has such a state.
struct CurveReport {
  std::string name;
  bool fitted;
  std::vector<double> stress;  ///< of the fit, MPa; NaN where the law has no such state
  int missing;                 ///< number of these
  double rms;                  ///< MPa
  double relative;             ///< rms over the rms of the data
  double largest;              ///< deviation of the largest size, MPa
  double largest_relative;     ///< the same over the largest stress of the data
  double largest_at;           ///< its stretch
  double end_relative;         ///< deviation at the last point over the data there; NaN if it is missing
  std::optional<StripReport> strip = {};
};

std::vector<CurveReport> curve_reports(const FitProblem& problem, const std::vector<double>& params);

/// A combination of relative changes of parameters, and its standard deviation.
struct Combination {
  std::vector<double> factors;  ///< [n_free], of unit length, of dp_k / scale_k; 0 for a held parameter
  double deviation;             ///< 1: the data leave it open by 100 %
};

/// What the data say of the parameters, linearised at the result: with J the derivatives of the weighted residuals by
/// p_k / scale_k, covariance s^2 Z (Z^T J^T J Z)^-1 Z^T by the singular values of J Z. The columns of Z span the
/// changes that keep to every bound and linear condition that is active (null space of their normals): along those
/// normals the result is held by what was asked for and not by the data. s^2 = chi^2 / (points - columns of Z) corrects
/// the noise that the data were said to have. Conditions of the law itself are seen only if they are repeated in
/// "Constraints", and "keep tangent positive" is not.
struct ParameterStatistics {
  std::vector<double> scale;  ///< [n_free]: |p|, but at least 1e-3 of the interval
  /// [n_free], in the parameter's unit; infinite: not determined at all; NaN: held.
  std::vector<double> deviation;
  std::vector<double> covariance;         ///< [n_free][n_free] in the parameters' units; NaN: held or undetermined
  std::vector<double> correlation;        ///< [n_free][n_free]; NaN: held or undetermined
  std::vector<Combination> combinations;  ///< one for each column of Z, the best determined first
  std::vector<int> at_bound;              ///< [n_free]: -1 at its lower bound, 1 at its upper, 0 inside
  std::vector<bool> held;                 ///< [n_free]: active bounds and conditions leave it no change
  /// [n_free]: changes of it, alone or with others, are seen by no curve, on a bound as well as inside.
  std::vector<bool> open;
  std::vector<std::string> active_conditions;  ///< names
  /// Parameters of which a small change leaves some fitted point without a state: the result lies on that edge.
  std::vector<std::string> at_edge;
  double noise;  ///< s: 1 if the residuals are as large as the noise that was given
};

/// A combination that varies by more than this is not determined.
inline constexpr double undetermined = 0.5;

ParameterStatistics parameter_statistics(const FitProblem& problem, const FitResult& result);

/// "0.71 w1_1 - 0.70 w2_1": the parameters with at least a fifth of the largest factor, largest first.
std::string combination_text(const FitProblem& problem, const Combination& combination);

}  // namespace toile::identify
