#pragma once

#include <string>
#include <vector>

namespace toile::identify::test {

/// Nominal stress of a clamped strip of 150 x 50 mm by the independent solution of high order
/// (test/data/plane_stress/strips.csv, accuracy 2e-5), pantyhose fabric.
struct StripReference {
  std::string material;
  double angle;                         ///< of the axis to the wale, deg
  std::vector<double> stretch, stress;  ///< 1, MPa
};
std::vector<StripReference> strip_references();

}  // namespace toile::identify::test
