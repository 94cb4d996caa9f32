#pragma once

#include <cmath>

#include "path/continuation.hpp"

namespace toile::solve {

/// The motion that the tangent resists least, without damping. The same on every rank.
struct SoftestMotion {
  bool found = false;
  double stiffness = 0.0;  ///< over the mean stiffness of an unknown; negative: the garment gives way
  size_t cluster = 0;      ///< that moves most in it
  Vec3 direction = Vec3::Zero();
  /// Nothing but round-off resists it.
  bool is_free() const { return found && std::abs(stiffness) <= round_off; }
  bool gives_way() const { return found && stiffness < -round_off; }
  /// So little that it matters: a membrane under tension has 1e-6 and less only with a thousand elements a side.
  bool is_soft() const { return found && stiffness < 1e-6; }
  static constexpr double round_off = 1e-12;
};

/// At the end of an attempt. The tangent is then another one than before. Collective.
SoftestMotion softest_motion(Equilibrium& equilibrium, const Attempt& attempt, size_t clusters);

}  // namespace toile::solve
