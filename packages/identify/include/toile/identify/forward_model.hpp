#pragma once

#include "toile/material/material.hpp"

namespace toile::identify {

/// What a law gives at the points of measured curves. Holds work arrays: one object a thread. A result depends on the
/// law and its parameters alone, not on what was evaluated before.
class ForwardModel {
 public:
  virtual ~ForwardModel() = default;

  virtual int size() const = 0;  ///< points
  /// Nominal stress [size] (MPa) for `params` [n_params] (uniform); NaN where there is no such state or it is not
  /// found. Returns their number.
  virtual int stress(const material::LawV1& law, const double* params, double* stress) = 0;
  /// The same, and gradient [n_params][size] of it. A parameter that is a choice has zeros.
  virtual int stress_and_gradient(const material::LawV1& law, const double* params, double* stress,
                                  double* gradient) = 0;
};

}  // namespace toile::identify
