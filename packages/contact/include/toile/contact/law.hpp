#pragma once

#include <Eigen/Core>
#include <memory>

#include "toile/body/surface.hpp"

namespace toile::contact {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// One node of the fabric (or the nodes that a seam ties) beside the body, as a law of contact sees it.
struct Touch {
  body::SurfacePoint surface;       ///< nearest to the node
  double offset = 0.0;              ///< of the fabric's contact surface inside its mid-surface, mm
  double multiplier = 0.0;          ///< contact force along the normal, an unknown of the solve, N
  double stiffness = 1.0;           ///< of the augmentation, N/mm, > 0
  Vec3 step = Vec3::Zero();         ///< of the node since the start of the step, mm; known to a law that follows it
  const double* history = nullptr;  ///< [Law::history_values] as the last step left them
};

/// What contact does to one node, in the form of the method of multipliers (Alart & Curnier 1991): the trial force is
/// max(0, multiplier - stiffness * gap).
///
/// At convergence multiplier = trial force and the gap is zero (in contact) or the multiplier is zero (free), whatever
/// the stiffness: it steers the iteration and does not enter the result.
struct NodeContact {
  bool active = false;       ///< trial force > 0
  double gap = 0.0;          ///< mm, from the contact surface of the fabric (the offset is taken off)
  double trial_force = 0.0;  ///< N
  Vec3 normal = Vec3::Zero();
  /// Of the step, with the multiplier held, N mm; (trial_force^2 - multiplier^2) / (2 stiffness) along the normal.
  double energy = 0.0;
  Vec3 residual = Vec3::Zero();  ///< gradient of the energy: less the force on the node, N
  /// Symmetric; with stiffness n n^T it is the energy's Hessian, N/mm. Along the normal -trial_force * Hessian(gap).
  Mat3 tangent = Mat3::Zero();
  double complementarity = 0.0;  ///< (multiplier - trial_force) / stiffness: the gap in contact, mm
};

/// Contact without a force along the surface, which every law begins with.
NodeContact normal_contact(const Touch& touch);

/// A law of contact between the fabric and a rigid body. Its calls are thread-safe.
///
/// A force along the surface may depend on the step and on what the law keeps of the steps before. Where it has no
/// potential with the multiplier held, `energy` is one to the first order about the step's end, and the solve converges
/// as fast as that is right.
class Law {
 public:
  Law() = default;
  Law(const Law&) = delete;
  Law& operator=(const Law&) = delete;
  virtual ~Law() = default;

  virtual NodeContact evaluate(const Touch& touch) const = 0;

  /// Whether Touch::step is needed.
  virtual bool follows_steps() const { return false; }
  /// Values that a node keeps from step to step, zero at first.
  virtual int history_values() const { return 0; }
  /// They, as the step that ends here leaves them.
  virtual void end_step(const Touch&, double*) const {}
};
using LawPtr = std::shared_ptr<const Law>;

/// The law of a scene that names none: the body pushes along its normal only.
LawPtr frictionless();

/// Multiplier that balances a nodal force `internal` (gradient of the strain energy, N): its part along the normal if
/// the node touches the body (|gap| <= tolerance, mm) and is pulled onto it, else zero.
double balancing_multiplier(const NodeContact& contact, const Vec3& internal, double tolerance);

}  // namespace toile::contact
