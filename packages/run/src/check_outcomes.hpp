#pragma once

#include <string>
#include <vector>

#include "toile/run/record.hpp"

namespace toile::run {

/// What became of a check.
struct CheckOutcome {
  std::string name, quantity;
  double value = 0.0;   ///< not a number if the quantity does not exist
  std::string unit;     ///< empty: dimensionless
  std::string allowed;  ///< the range in words
  bool holds = false;
  std::string message = {};  ///< why it does not hold; empty if it does
};

/// Of the last accepted step, in the scene's order; before them, if it does not hold, that the elements see the body
/// (Pierced), which every scene with a body is checked for.
std::vector<CheckOutcome> check_outcomes(const Record& record);

}  // namespace toile::run
