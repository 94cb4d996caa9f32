#include "toile/contact/normal_contact.hpp"

#include <algorithm>
#include <cmath>

namespace toile::contact {

NodeContact evaluate(const body::Surface& surface, const Vec3& x, double offset, double multiplier, double stiffness) {
  NodeContact c;
  const body::SurfacePoint p = surface.closest(x);
  c.gap = p.gap - offset;
  c.normal = p.normal;
  c.trial_force = std::max(0.0, multiplier - stiffness * c.gap);
  c.active = c.trial_force > 0.0;
  c.energy = (c.trial_force * c.trial_force - multiplier * multiplier) / (2.0 * stiffness);
  c.complementarity = (multiplier - c.trial_force) / stiffness;
  if (c.active) {
    c.residual = -c.trial_force * p.normal;
    c.curvature = -c.trial_force * p.hessian;
  }
  return c;
}

double balancing_multiplier(const NodeContact& contact, const Vec3& internal, double tolerance) {
  if (std::abs(contact.gap) > tolerance) return 0.0;
  return std::max(0.0, internal.dot(contact.normal));
}

double pressure(double force, double area) {
  return area > 0.0 ? force / area : 0.0;
}

}  // namespace toile::contact
