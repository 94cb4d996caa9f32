#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/contact/law.hpp"
#include "toile/element/element.hpp"
#include "toile/material/material.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::solve {

using Vec3 = Eigen::Vector3d;

/// What a support does to the directors of its nodes (shells only).
enum class DirectorSupport {
  free,      ///< a hinge
  held,      ///< a clamp
  symmetry,  ///< stays perpendicular to each held direction: the plane of symmetry
  diaphragm  ///< tilts about the edge only: stays in the plane of its start and the one direction that is not held
};

/// How much of its way a support has gone at a load: piecewise linear, constant beyond its ends; the load itself if
/// empty.
struct MotionPath {
  std::vector<double> loads;   ///< strictly increasing
  std::vector<double> shares;  ///< [load]
  double share(double load) const;
  bool operator==(const MotionPath& other) const { return loads == other.loads && shares == other.shares; }
};

/// Rotation about an axis that is fixed in space.
struct Turn {
  Vec3 point = Vec3::Zero();  ///< of the axis, mm
  Vec3 axis = Vec3::UnitZ();  ///< unit vector
  double angle = 0.0;         ///< rad at share 1, right-handed about `axis`
};

/// Three orthonormal vectors as rows: axes of space, or tangents t_1, t_2 and director of a shell's node
/// (right-handed).
using Frame = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Nodes whose positions are held in some directions; on their way they turn and are moved, both by a share that goes
/// with the load: x = point + Exp(share angle axis) (X - point) + share displacement, with X the placed position.
struct Support {
  std::string name;
  std::vector<int> nodes;
  std::array<bool, 3> held{};        ///< along each of the support's axes
  Vec3 displacement = Vec3::Zero();  ///< mm at share 1, along them
  DirectorSupport director = DirectorSupport::free;
  std::optional<Turn> turn = std::nullopt;  ///< takes held directors with it; needs the directions across its axis held
  MotionPath path = {};
  std::vector<Frame> axes = {};  ///< [node] the support's axes; empty: x, y and z

  Vec3 axis(size_t node, Eigen::Index i) const { return axes.empty() ? Vec3(Vec3::Unit(i)) : Vec3(axes[node].row(i)); }
  /// Of its node number `node` in space at share 1, turn left out, mm.
  Vec3 motion(size_t node) const { return axes.empty() ? displacement : Vec3(axes[node].transpose() * displacement); }
};

/// Dead force or moment, shared by some nodes.
struct NodalLoad {
  std::string name;
  std::vector<int> nodes;
  std::vector<double> share;  ///< [node] times `value`: mm of edge, or 1
  Vec3 value = Vec3::Zero();  ///< N or N mm per share at load 1
  bool moment = false;        ///< turns the directors about a fixed axis in space
};

/// Pressure on one block of the mesh, along the current normal x_,1 x x_,2.
struct FollowerPressure {
  std::string name;
  int block = 0;
  double pressure = 0.0;  ///< MPa at load 1, per current area
};

struct ContactOptions {
  bool offset_by_half_thickness = true;  ///< false: contact at the mid-surface (membrane theory)
  bool pressure_on_inner_face = false;   ///< written per area of the inner face, not of the mid-surface
  /// Augmentation relative to the mean diagonal of the tangent. Steers the iteration, not the result.
  double relative_stiffness = 1.0;
  contact::LawPtr law = contact::frictionless();
};

/// What a shell has beyond a membrane.
struct ShellModel {
  int layers = 3;                 ///< integration points through the thickness
  double shear_modulus = 0.0;     ///< of transverse shear, correction factor included, MPa
  bool placed_reference = false;  ///< the placed shape is free of stress, not the flat pattern
};

/// Element formulation and fabric of one block of the mesh.
struct BlockModel {
  const element::Element* element = nullptr;
  const material::Material* material = nullptr;
  ShellModel shell = {};
  bool is_shell() const { return element->dofs_per_node() > 3; }
};

/// Everything that is solved for, the same on every rank. The referenced objects must outlive it.
struct Problem {
  const mesh::Mesh* mesh = nullptr;
  /// Nodes that a seam ties, master first; every node is in exactly one cluster.
  std::vector<std::vector<int>> clusters;
  std::vector<std::string> seam;   ///< [cluster] name of a seam that ties it, or empty; empty altogether: not known
  std::vector<BlockModel> models;  ///< one a block
  std::vector<Support> supports;
  std::vector<NodalLoad> loads;
  std::vector<FollowerPressure> pressures;
  /// [panel] Panels of the mesh that lie between it and the body; empty altogether: none do.
  std::vector<std::vector<int>> beneath;
  const body::Surface* surface = nullptr;  ///< null: no contact is built
  ContactOptions contact;
  bool crossings = false;  ///< fabric that passes through fabric is looked for in every state whose fields are computed
  std::vector<std::vector<int>> element_rank;  ///< [block][element] owner
  std::vector<int> cluster_rank;               ///< [cluster] owner, a rank that has an element touching it
};

/// A converged (or starting) configuration, the same on every rank.
struct State {
  std::vector<Vec3> position;         ///< [cluster] position of the master, mm
  std::vector<double> contact_force;  ///< [cluster] N
  std::vector<double> offset;         ///< [cluster] contact surface inside the mid-surface, mm
  /// [cluster][contact::Law::history_values]; empty at first, and where the law keeps nothing.
  std::vector<double> contact_history;
  /// [node] of shells, empty without: the director's frame, and the rotations theta that have led to it (rad). Theta is
  /// additive and never reset; the tangents are transported along with the director, never turned about it.
  std::vector<Frame> frame;
  std::vector<std::array<double, 2>> rotation;
  double seam = 0.0;  ///< 0: placed, 1: closed
  double load = 0.0;
};

/// Position of a node: its cluster's master plus what is left of the placed separation (doc/theory.md, "Seams": x = T y
/// + b).
Vec3 node_position(const Problem& problem, const State& state, int cluster, int node);

/// Start of a run: the placed positions, no contact force. Directors are the normals of the placed panels; where a
/// support demands symmetry they lie in its plane, with t_1 normal to it.
State placed_state(const Problem& problem);

/// [node] orthonormal normals of the planes of symmetry in which a node's director must stay.
std::vector<std::vector<Vec3>> symmetry_planes(const Problem& problem);

/// [node] frames of the shells' nodes at the start, see placed_state; the identity at other nodes.
std::vector<Frame> start_frames(const Problem& problem);

/// Normal of the plane in which a diaphragm keeps the director of its node number `node`, from that at the start; its
/// length is the sine of the angle between the director and the direction that is not held.
Vec3 diaphragm_normal(const Support& support, size_t node, const Vec3& director);

/// Nodes of shells, [node].
std::vector<bool> shell_nodes(const Problem& problem);

/// The frame after the rotation w_1 t_1 + w_2 t_2 of its director, d = Exp(d_n, w); the tangents are transported along
/// the great circle from d_n to d.
Frame rotated(const Frame& frame, double w1, double w2);

}  // namespace toile::solve
