#pragma once

#include "toile/criteria/fabric.hpp"

namespace toile::criteria {

/// Largest error of dS/dp at the admissible ones of `states` and of which parameter, against finite differences: over
/// the change of the stress when the parameter doubles and the stress itself; infinite where dS/dp is not a number.
struct ParameterError {
  double largest = 0.0;
  std::string parameter;
  Strain where = {1.0, 1.0, 0.0};
};
ParameterError parameter_error(const Fabric& fabric, const std::vector<Outputs>& states);

}  // namespace toile::criteria
