#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "toile/solve/problem.hpp"

namespace toile::solve {

/// Where a component of a cluster's position comes from: a straight or circular path, or both added.
struct HeldComponent {
  bool held = false;
  double base = 0.0;          ///< mm, at the start
  double displacement = 0.0;  ///< mm when its support has gone all its way
  int support = -1;           ///< index into Problem::supports; -1: held against a null motion
  double angle = 0.0;         ///< of a support that turns, rad, all the way
  double radial = 0.0;        ///< component of r, from the axis to the placed node, mm
  double tangential = 0.0;    ///< component of axis x r, mm

  double position(double share) const;  ///< mm, where the support has gone this share of its way
};

/// What a stage holds.
struct Held {
  std::vector<std::array<HeldComponent, 3>> position;  ///< [cluster]
  std::vector<std::array<bool, 2>> rotation;           ///< [node] of shells: not an unknown; empty without shells
  /// [node] support whose turn takes the held director along, or -1; empty where none does.
  std::vector<int> turned_by;
};

/// The path on which support number `index` takes the component `direction` of a node that is placed at X.
HeldComponent held_component(const Problem& problem, size_t index, int direction, const Vec3& placed);
/// Whether two supports take a component along the same path, within 1e-9 mm, at the same loads.
bool move_alike(const Problem& problem, const HeldComponent& a, const HeldComponent& b);

/// What the supports hold that are not released. `state`: whose frames tell the directions of symmetry.
/// Throws base::InputError for supports that contradict each other.
Held find_held(const Problem& problem, const State& state, const std::set<std::string>& released);

/// The inverse of rotated(frame, w_1, w_2): the shortest rotation of the frame's director to `director`.
std::array<double, 2> rotation_to(const Frame& frame, const Vec3& director);

}  // namespace toile::solve
