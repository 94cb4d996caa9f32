#pragma once

#include <string>

#include "toile/base/parameters.hpp"

namespace toile::study {

/// Where the results of finer and finer meshes go: f(h) = value + C h^order.
struct Extrapolation {
  double value = 0.0;
  /// Of `value`: what it changes by if the order is anywhere in its interval, and at least a tenth of its distance from
  /// the finest mesh. If it cannot be trusted, three times the
  /// range of the three finest meshes, about the finest.
  double uncertainty = 0.0;
  double order = 0.0;         ///< observed on the three finest meshes; NaN: none
  double order_spread = 0.0;  ///< largest deviation of the orders of other three neighbours; NaN: only three meshes
  bool trusted = false;
  std::string why;  ///< not
};

/// `sizes`: of the elements, falling; `values`: of as many meshes. Richardson (1911) with the observed order on meshes
/// of any ratio; Roache, Annu. Rev. Fluid Mech. 29 (1997) 123. It is trusted if the three finest meshes come nearer
/// from one side, the order is 0.95 to 4.5, and it is within 0.75 of that of the meshes before (of four or more).
Extrapolation extrapolate(const base::Reals& sizes, const base::Reals& values);

}  // namespace toile::study
