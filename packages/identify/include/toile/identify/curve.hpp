#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/identify/clamped_strip.hpp"
#include "toile/identify/homogeneous.hpp"

namespace toile::identify {

/// A measured curve in the units of Toile.
struct Curve {
  std::string name;
  TestKind kind = TestKind::uniaxial;
  double angle = 0.0;                              ///< of the test's axis to the wale, rad
  double weight = 1.0;                             ///< factor of its squared residuals; 0: only predicted
  std::optional<StripSpecimen> strip;              ///< evaluated between its clamps; empty: a homogeneous state
  std::vector<double> stretch, stress, deviation;  ///< [n]: 1, nominal stress (MPa), standard deviation of it (MPa)

  std::vector<TestPoint> points() const;  ///< [n]
};

/// Description of the entries of "Data".
base::Spec curve_spec();

/// Reads the CSV file that an entry of "Data" names. One line of titles, "name [unit]"; lines that begin with # are
/// comments. Elongation: stretch [-], strain [- or %], displacement (with "gauge length"). Load: nominal stress,
/// line force (over the thickness, mm), force (over "width" and the thickness). Other columns are not read.
/// Throws InputError that names file, line and column: a column or unit that is missing or unknown, what is not a
/// number, an elongation that does not increase strictly, fewer than 3 rows; or of "model": a clamped strip that is not
/// uniaxial or lacks "gauge length" or "width"; "elements across" of a homogeneous state.
Curve read_curve(const base::List& list, double thickness);

}  // namespace toile::identify
