#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "toile/identify/problem.hpp"
#include "toile/identify/spec.hpp"

namespace toile::identify {

/// chi^2 with the clamped strips before and after the polish with them.
struct StripPolish {
  double before, after;
};

/// One search with its polish. Where a fitted curve is a clamped strip, both take a homogeneous state in its place, and
/// the best start is polished again with the strips.
struct Start {
  unsigned seed;
  double searched, polished;  ///< chi^2 after each
  double merit;               ///< of the polished one, see Residuals::merit
  std::vector<double> x;
  std::optional<StripPolish> strips = {};
};

struct FitResult {
  std::vector<Start> starts;
  std::size_t best = 0;        ///< of the starts
  std::vector<double> params;  ///< [n_params] of the best one
  double chi_squared = 0.0;
  std::string falls;  ///< first place to which the stress falls although it must rise; empty: none

  const std::vector<double>& x() const { return starts[best].x; }
};

/// How far a fit is. Its phases, one after the other, take times that cannot be told from each other.
struct FitStatus {
  std::string phase;
  double part;         ///< of the phase that is done, 0..1
  double chi_squared;  ///< smallest one of the current start
};
using FitProgress = std::function<void(const FitStatus&)>;

/// Runs every start. The same problem and seed give the same result, to the last bit. Throws Error (solve_failed) if no
/// start ends at a candidate that has a state at every fitted point, or if a derivative of one is not a number.
FitResult fit(const FitProblem& problem, const Algorithm& algorithm, const FitProgress& progress);

}  // namespace toile::identify
