#pragma once

#include <Eigen/Core>

#include "toile/body/surface.hpp"

namespace toile::contact {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Frictionless contact of one node with the rigid body, in the form of the method of multipliers
/// (Alart & Curnier 1991): the trial force is max(0, multiplier - stiffness * gap).
///
/// At convergence multiplier = trial force and the gap is zero (in contact) or the multiplier is zero (free), whatever
/// the stiffness: it steers the iteration and does not enter the result.
struct NodeContact {
  bool active = false;       ///< trial force > 0
  double gap = 0.0;          ///< mm, from the contact surface of the fabric (the offset is taken off)
  double trial_force = 0.0;  ///< N
  Vec3 normal = Vec3::Zero();
  double energy = 0.0;            ///< (trial_force^2 - multiplier^2) / (2 stiffness), N mm
  Vec3 residual = Vec3::Zero();   ///< gradient of the energy: -trial_force * normal, N
  Mat3 curvature = Mat3::Zero();  ///< -trial_force * Hessian(gap), N/mm; the energy's Hessian adds stiffness n n^T
  double complementarity = 0.0;   ///< (multiplier - trial_force) / stiffness: the gap in contact, mm
};

/// Contact of the node at `x` whose contact surface lies `offset` (mm) inside the mid-surface.
/// `multiplier` is the node's contact force (N), `stiffness` the augmentation (N/mm, > 0).
NodeContact evaluate(const body::Surface& surface, const Vec3& x, double offset, double multiplier, double stiffness);

/// Multiplier that balances a nodal force `internal` (gradient of the strain energy, N): its part along the normal if
/// the node touches the body (|gap| <= tolerance, mm) and is pulled onto it, else zero.
double balancing_multiplier(const NodeContact& contact, const Vec3& internal, double tolerance);

/// Pressure (MPa) of a node: contact force per area that belongs to it (mm^2). Exact for a constant pressure.
double pressure(double force, double area);

}  // namespace toile::contact
