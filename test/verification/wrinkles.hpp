#pragma once

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <initializer_list>
#include <string>
#include <vector>

#include "reals.hpp"
#include "verification/plane_scene.hpp"

namespace toile::test {

/// A scene of input/ that the caller may change.
Teuchos::ParameterList changeable_scene(const std::string& file);

/// Nodes of the panel on a line of the pattern: their present place along it and their displacement out of the plane.
struct Profile {
  std::vector<double> at;      ///< mm, ascending
  std::vector<double> height;  ///< mm

  double amplitude() const;         ///< largest |height|, mm
  double root_mean_square() const;  ///< of the heights, mm; it does not depend on where the crests lie
  /// Where the height changes its sign, by linear interpolation, mm.
  std::vector<double> zeros() const;
};

/// The nodes whose pattern coordinate x (`axis` 0) or y (1) is `value`, within 1e-6 mm.
Profile profile(const PlaneRun& run, size_t step, int axis, double value);

/// Largest displacement out of the plane of all nodes, mm.
double largest_height(const PlaneRun& run, size_t step);

/// Sums over the steps.
int newton_iterations(const PlaneRun& run);
int cut_backs(const PlaneRun& run);

}  // namespace toile::test
