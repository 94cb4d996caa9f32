#pragma once

namespace toile::base {

/// Toile computes in mm, N, MPa, s.
inline constexpr double kpa_per_mpa = 1000.0;
/// Conventional millimetre of mercury, 133.3224 Pa; hosiery classes are given in it.
inline constexpr double mmhg_per_kpa = 7.50062;

constexpr double mpa_to_kpa(double pressure) {
  return pressure * kpa_per_mpa;
}
constexpr double kpa_to_mmhg(double pressure) {
  return pressure * mmhg_per_kpa;
}
constexpr double mpa_to_mmhg(double pressure) {
  return kpa_to_mmhg(mpa_to_kpa(pressure));
}

}  // namespace toile::base
