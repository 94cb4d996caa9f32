// A law of contact with friction, as a user would add one: only what the body does to a node.
#pragma once

#include <cmath>

#include "toile/contact/law.hpp"

namespace toile::test {

/// Coulomb's friction of each step: coefficient times contact force against the node's way u along the surface since
/// the start of the step, smoothed by u / sqrt(u^2 + slip^2).
class Coulomb : public contact::Law {
 public:
  Coulomb(double coefficient, double slip) : coefficient_(coefficient), slip_(slip) {}

  contact::NodeContact evaluate(const contact::Touch& touch) const override {
    contact::NodeContact c = contact::normal_contact(touch);
    if (!c.active) return c;
    const contact::Mat3 along = contact::Mat3::Identity() - c.normal * c.normal.transpose();
    // Half the gradient of |u|^2: u, and what the turn of the normal makes of it.
    const contact::Vec3 way = along * touch.step;
    const contact::Vec3 slope = way - c.normal.dot(touch.step) * touch.surface.hessian * touch.step;
    const double length = std::sqrt(way.squaredNorm() + slip_ * slip_), force = coefficient_ * touch.multiplier;
    c.energy += force * (length - slip_);
    c.residual += force / length * slope;
    c.tangent += force / length * (along - slope * slope.transpose() / (length * length));
    return c;
  }
  bool follows_steps() const override { return true; }

 private:
  double coefficient_;
  double slip_;  ///< mm
};

}  // namespace toile::test
