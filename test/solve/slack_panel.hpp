// Fabric that wrinkles: a panel of a tension field whose sides are nearer to each other than it is wide.
#pragma once

#include "panels.hpp"
#include "toile/material/relaxed_response.hpp"

namespace toile::test {

/// Neo-Hookean.
namespace slack_fabric {
constexpr double C10 = 8.4667e-3;  ///< MPa
constexpr double thickness = 0.7;  ///< mm
constexpr double residual = 1e-3;  ///< stiffness left in compression, a part of the undeformed fabric's
}  // namespace slack_fabric

/// Held at two sides.
inline Panels slack_panel() {
  using namespace slack_fabric;
  const material::LawV1& law = *material::find("neo-hookean");
  Panels panels(std::make_shared<material::Material>(
      law, std::vector<double>{C10}, thickness,
      std::make_shared<material::RelaxedResponse>(law, material::Relaxation::tension_field, residual)));
  panels.add(solve::Vec3(3.0, 5.0, 7.0), 0.7 * solve::Vec3::UnitX(), 0.8 * solve::Vec3::UnitY(), 0);
  panels.hold(0, 0);
  panels.hold(0, Panels::across);
  return panels;
}

}  // namespace toile::test
