#pragma once

#include <array>
#include <string>
#include <vector>

#include "toile/material/ellipticity.hpp"
#include "toile/solve/problem.hpp"

namespace toile::solve {

/// Where the fabric has lost strong ellipticity (material::Ellipticity) in its plane: material points at which results
/// depend on the mesh.
struct LossOfEllipticity {
  /// A panel that has such points.
  struct Panel {
    std::string name;
    int points;  ///< that have lost it
    int of;      ///< all points of the panel
  };
  std::vector<Panel> panels;
  bool found() const { return !panels.empty(); }

  // Of the point with the smallest eigenvalue over the shear modulus of the undeformed fabric.
  std::string panel;
  int element = 0;  ///< of the panel, from 1
  Vec3 position = Vec3::Zero();
  mesh::Vec2 pattern = {};    ///< mm; position and pattern of the element's centre
  std::array<double, 3> C{};  ///< C11, C22, C12 in the material frame
  std::array<double, 3> S{};  ///< second Piola-Kirchhoff, MPa
  material::Ellipticity value{};
  double shear_modulus = 0.0;  ///< MPa

  /// One sentence: how many points of which panels, the worst point with its state, and what to do. Only if found().
  std::string text() const;
};

/// Looks at the integration points of the whole garment (of shells: at their mid-surface) on the calling rank. Points
/// that the material does not admit are passed over. A fabric that relaxes has, where it wrinkles, an eigenvalue of
/// zero: that is no loss.
LossOfEllipticity find_loss_of_ellipticity(const Problem& problem, const State& state);

}  // namespace toile::solve
