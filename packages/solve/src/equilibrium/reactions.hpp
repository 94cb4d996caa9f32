#pragma once

#include "equilibrium/kinematics.hpp"
#include "terms/term.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::solve {

/// What each term does to the nodes of one rank.
struct TermForces {
  Forces fabric, load, damping, contact;
  double load_moments = 0.0;  ///< sum of the components of dead moments, N mm
};

/// Forces by term, and the rest of them, which the supports carry. `lever`: what makes moments comparable to forces,
/// mm; `least`: magnitude of forces that counts at least, N. Collective.
ForceBalance balance_of(const Problem& problem, const Layout& layout, const Kinematics& kinematics,
                        const Configuration& at, const TermForces& terms, double lever, double least);

}  // namespace toile::solve
