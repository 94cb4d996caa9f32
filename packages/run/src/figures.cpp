#include "figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "toile/base/units.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::run {

Figures figures_of(const solve::Fields& fields, const solve::StepReport& report) {
  Figures f;
  f.smallest_pressure = std::numeric_limits<double>::infinity();
  for (const double p : fields.pressure) {
    f.largest_pressure = std::max(f.largest_pressure, base::mpa_to_kpa(p));
    if (p > 0.0) f.smallest_pressure = std::min(f.smallest_pressure, base::mpa_to_kpa(p));
  }
  if (f.largest_pressure == 0.0) f.smallest_pressure = 0.0;
  double largest_stress = 0.0;
  for (const double stress : solve::named(solve::element_fields(fields), "cauchy_major").values)
    largest_stress = std::max(largest_stress, std::abs(stress));
  if (std::abs(fields.smallest_principal_stress) > noise * largest_stress)
    f.smallest_stress = base::mpa_to_kpa(fields.smallest_principal_stress);
  solve::ForceBalance written = report.balance;
  written.contact = solve::contact_resultant(fields);
  f.force_balance = written.magnitude > 0.0 ? written.sum().norm() / written.magnitude : 0.0;
  f.largest_gap = report.accuracy.gap;
  f.dissipation_ratio = report.energy.dissipation_ratio;
  f.extrapolated = report.extrapolated;
  return f;
}

}  // namespace toile::run
