#pragma once

#include <limits>

namespace toile::study {

/// What is not known.
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace toile::study
