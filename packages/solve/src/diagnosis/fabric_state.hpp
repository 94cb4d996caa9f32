#pragma once

#include <array>
#include <string>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// One integration point of the fabric.
struct FabricPoint {
  bool found = false;
  std::string panel;
  int element = 0;  ///< of the panel, from 1
  Vec3 position = Vec3::Zero();
  mesh::Vec2 pattern = mesh::Vec2::Zero();  ///< mm; position and pattern of the element's centre
  std::array<double, 2> stretch{};          ///< principal, larger first
  std::array<double, 2> along{};            ///< stretch along the wale and along the course

  /// `panel "front", element 12, at (1, 2, 3) mm, in the pattern at (1, 2) mm: stretch 1.2 along the wale ...`
  std::string text() const;
};

/// How far the fabric is deformed in a state, over all its integration points (of shells: of their mid-surface).
struct FabricState {
  FabricPoint most_stretched, most_compressed;
  int points = 0, without_energy = 0;
  /// Sums over the points of the tensile and of the compressive principal stresses (Cauchy, MPa).
  double tension = 0.0, compression = 0.0;
  FabricPoint worst_without_energy;  ///< the one whose stretches are farthest from one
  /// Nothing is strained by more than rounded positions and a converged residual leave.
  bool is_slack() const;
};

/// Looks at the whole garment on the calling rank.
FabricState fabric_state(const Problem& problem, const State& state);

}  // namespace toile::solve
