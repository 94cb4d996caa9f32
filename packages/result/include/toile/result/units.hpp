#pragma once

namespace toile::result {

inline constexpr double kpa_per_mpa = 1000.0;
inline constexpr double mmhg_per_kpa = 7.50062;  ///< medical hosiery states pressure in mmHg

}  // namespace toile::result
