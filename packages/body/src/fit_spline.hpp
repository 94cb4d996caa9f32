#pragma once

#include <memory>
#include <vector>

#include "spline_field.hpp"

namespace toile::body {

/// What a level set shall be at a point.
struct LevelSetDatum {
  int cell = -1;
  Vec3 point;                                        ///< mm
  Eigen::Vector4d wanted = Eigen::Vector4d::Zero();  ///< f, mm, and its gradient
  Eigen::Vector4d change = Eigen::Vector4d::Zero();  ///< of what is wanted, with the logarithm of the smoothing
  double area = 0.0;                                 ///< mm^2
  bool has_gradient = true;
};

/// A fitted level set, and what it would change by if the smoothing's weight were six times as large, to first order
/// in its logarithm.
struct FittedSplines {
  SplineField value;
  SplineField doubt;
};

/// Least-squares fit, with the integral of the squared third derivatives times `smoothing` (of each cell); see the
/// README. `area`: of the facets that the grid covers, mm^2. `held`: marks unknowns that stay zero. Throws InputError
/// if the system cannot be factorised.
FittedSplines fit_spline(std::shared_ptr<const SheetGrid> grid, const std::vector<LevelSetDatum>& data,
                         const std::vector<double>& smoothing, double area, const std::vector<char>& held);

}  // namespace toile::body
