// The fabric at the start: stretches, how far round the body it reaches, what it would press, what holds it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "start_shape.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/fields.hpp"

namespace toile::scene {

/// Smallest and largest of some values, and where.
struct Extremes {
  double smallest = 0.0, largest = 0.0, mean = 0.0;
  solve::Vec3 at_smallest = solve::Vec3::Zero(), at_largest = solve::Vec3::Zero();
};

/// One panel.
struct PanelStart {
  std::string name;
  bool placed_is_stress_free = false;   ///< a shell whose stretches count from its placed shape: none at the start
  Extremes wale, course, major, minor;  ///< stretches at the elements' centres
  std::optional<Extremes> round;        ///< round the body if sewn side to side: once closed and on the body
  std::optional<double> high_pressure;  ///< MPa, that nine tenths of the panel stay below, of the placed fabric
  int inside = 0;                       ///< nodes in the body
  double depth = 0.0;                   ///< mm, of the deepest one
  solve::Vec3 deepest = solve::Vec3::Zero();
  double size = 0.0;  ///< mm, mean distance of neighbouring nodes
};

/// A part of the garment that nothing holds.
struct LoosePart {
  std::string panels;  ///< names, for messages
  double gap = 0.0;    ///< mm, of its nearest node from the body; infinite without a body
};

/// [panel] of the start that scene.start() gives. `fields`: its own.
std::vector<PanelStart> look_at_panels(const Scene& scene, const solve::Fields& fields);

/// Parts without a support that do not lie on the body.
std::vector<LoosePart> loose_parts(const Scene& scene, const solve::Fields& fields);

}  // namespace toile::scene
