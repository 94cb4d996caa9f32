#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/element/element.hpp"
#include "toile/material/material.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::solve {

using Vec3 = Eigen::Vector3d;

/// Nodes whose positions are held in some directions, and moved by `displacement` at full load.
struct Support {
  std::string name;
  std::vector<int> nodes;
  std::array<bool, 3> held{};
  Vec3 displacement = Vec3::Zero();  ///< mm at load 1
};

/// Dead load on the chain of nodes of an edge.
struct EdgeLoad {
  std::string name;
  std::vector<int> nodes;
  Vec3 traction = Vec3::Zero();  ///< N per mm of pattern edge at load 1
};

struct ContactOptions {
  bool offset_by_half_thickness = true;  ///< false: contact at the mid-surface (membrane theory)
  /// Augmentation relative to the mean diagonal of the tangent. Steers the iteration, not the result.
  double relative_stiffness = 1.0;
};

/// Element formulation and fabric of one block of the mesh.
struct BlockLaw {
  const element::Element* element = nullptr;
  const material::Material* material = nullptr;
};

/// Everything that is solved for, the same on every rank. The referenced objects must outlive it.
struct Problem {
  const mesh::Mesh* mesh = nullptr;
  /// Nodes that a seam ties, master first; every node is in exactly one cluster.
  std::vector<std::vector<int>> clusters;
  std::vector<BlockLaw> laws;  ///< one a block
  std::vector<Support> supports;
  std::vector<EdgeLoad> loads;
  const body::Surface* surface = nullptr;  ///< null: no contact is built
  ContactOptions contact;
  std::vector<std::vector<int>> element_rank;  ///< [block][element] owner
  std::vector<int> cluster_rank;               ///< [cluster] owner, a rank that has an element touching it
};

/// A converged (or starting) configuration, the same on every rank.
struct State {
  std::vector<Vec3> position;         ///< [cluster] position of the master, mm
  std::vector<double> contact_force;  ///< [cluster] N
  std::vector<double> offset;         ///< [cluster] contact surface inside the mid-surface, mm
  double seam = 0.0;                  ///< 0: placed, 1: closed
  double load = 0.0;
};

/// Position of a node: its cluster's master plus what is left of the placed separation (DESIGN: x = T y + b).
Vec3 node_position(const Problem& problem, const State& state, int cluster, int node);

/// Start of a run: the placed positions, no contact force.
State placed_state(const Problem& problem);

}  // namespace toile::solve
