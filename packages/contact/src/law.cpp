#include "toile/contact/law.hpp"

#include <algorithm>
#include <cmath>

namespace toile::contact {

NodeContact normal_contact(const Touch& touch) {
  NodeContact c;
  c.gap = touch.surface.gap - touch.offset;
  c.normal = touch.surface.normal;
  c.trial_force = std::max(0.0, touch.multiplier - touch.stiffness * c.gap);
  c.active = c.trial_force > 0.0;
  c.energy = (c.trial_force * c.trial_force - touch.multiplier * touch.multiplier) / (2.0 * touch.stiffness);
  c.complementarity = (touch.multiplier - c.trial_force) / touch.stiffness;
  if (c.active) {
    c.residual = -c.trial_force * c.normal;
    c.tangent = -c.trial_force * touch.surface.hessian;
  }
  return c;
}

double balancing_multiplier(const NodeContact& contact, const Vec3& internal, double tolerance) {
  if (std::abs(contact.gap) > tolerance) return 0.0;
  return std::max(0.0, internal.dot(contact.normal));
}

}  // namespace toile::contact
