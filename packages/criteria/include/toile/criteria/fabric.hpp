#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "toile/material/material.hpp"

namespace toile::criteria {

/// C11, C22, C12 of one state in the material frame (1 wale, 2 course).
using Strain = std::array<double, 3>;

/// All outputs of a law at one state; layouts and units of material::LawV1.
struct Outputs {
  Strain C = {1.0, 1.0, 0.0};
  double W = 0.0;
  std::array<double, 3> S = {};
  std::array<double, 6> D = {};
  double thickness_stretch = 0.0;
  std::uint8_t status = material::point_ok;

  bool admissible() const { return status != material::point_not_admissible; }
  /// Whether every output is a finite number.
  bool finite() const;
  /// Both principal stresses are tensile: S positive definite (then F S F^T is), beyond `tolerance` (MPa).
  bool tensile(double tolerance = 0.0) const;
  /// d2W/dE_a dE_b, E = (C11/2, C22/2, C12).
  double tangent(int a, int b) const;
};

/// A law with one set of values: what is checked.
struct Fabric {
  std::string name;
  const material::LawV1* law;
  std::vector<double> params;  ///< [n_params]

  /// One batch. `counted`: how many points the law says are not admissible.
  std::vector<Outputs> evaluate(const std::vector<Strain>& strains, int* counted = nullptr) const;
  Outputs evaluate(const Strain& strain) const { return evaluate(std::vector<Strain>{strain}).front(); }
};

/// C = F^T F of F = [[wale, shear], [0, course]]. Every C is that of one such F.
Strain strain_of(double wale, double course, double shear);

}  // namespace toile::criteria
