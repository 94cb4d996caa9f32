#pragma once

#include <array>
#include <optional>
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

/// Components q of a cluster's position y: q = across y and y = along q. A held component is the one along its
/// support's direction, whatever the angles between these; the free ones are along orthonormal directions across all of
/// them. Components of a force are f.dy/dq, so the force that belongs to a component g is g times its row of `across`.
struct Basis {
  Eigen::Matrix3d across = Eigen::Matrix3d::Identity();  ///< rows: the directions
  Eigen::Matrix3d along = Eigen::Matrix3d::Identity();   ///< its inverse
  bool turned = false;                                   ///< not x, y and z
};

/// What a stage holds.
struct Held {
  std::vector<std::array<HeldComponent, 3>> position;  ///< [cluster]
  std::vector<std::array<bool, 2>> rotation;           ///< [node] of shells: not an unknown; empty without shells
  /// [node] support whose turn takes the held director along, or -1; empty where none does.
  std::vector<int> turned_by;
  std::vector<Basis> basis = {};  ///< [cluster] of its components; empty where all are x, y and z

  Vec3 direction(int cluster, Eigen::Index component) const;  ///< unit
};

/// Two supports that cannot both hold a node.
struct Contradiction {
  size_t first, second;  ///< indices into Problem::supports
  int node;
  Vec3 direction;                    ///< of the second one
  double first_moves, second_moves;  ///< mm along it
  bool nearly_parallel;              ///< their directions are neither the same nor clearly different
};

/// What the supports hold of the positions that are not released; the components that are not held are free. `held`
/// keeps what was found before a contradiction.
std::optional<Contradiction> hold_positions(const Problem& problem, const std::set<std::string>& released, Held& held);

/// What the supports hold that are not released. `state`: whose frames tell the directions of symmetry.
/// Throws base::InputError for supports that contradict each other.
Held find_held(const Problem& problem, const State& state, const std::set<std::string>& released);

/// The inverse of rotated(frame, w_1, w_2): the shortest rotation of the frame's director to `director`.
std::array<double, 2> rotation_to(const Frame& frame, const Vec3& director);

}  // namespace toile::solve
