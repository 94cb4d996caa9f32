#pragma once

#include "toile/criteria/map.hpp"

namespace toile::criteria {

/// Polyconvexity in the plane: is W(F) = g(F, det F) with a convex g, F 2 x 2 (Ball, Arch. Rat. Mech. Anal. 63 (1977))?
/// That is so exactly if for every F0 there is a number a with
///   e(F) = W(F) - W(F0) - P(F0):(F - F0) >= a det(F - F0)   for all F, det F > 0,
/// P = dW/dF: the supporting plane of g; its slope along F is fixed by the derivative, and in two dimensions
/// det F - det F0 - cof F0:(F - F0) = det(F - F0). Each F is a lower or an upper bound on a, by the sign of
/// det(F - F0). Bounds that contradict each other refute polyconvexity by the two states themselves; bounds that do not
/// leave it undecided, since other states may. (A rank-one step, det(F - F0) = 0, asks for e >= 0: rank-one convexity.
/// Near F0 the condition is that of the acoustic tensor: of quadratic forms in two dimensions rank-one convexity and
/// polyconvexity are the same, Terpstra, Math. Ann. 116 (1939).)
/// The plane-stress energy of a law that is polyconvex in space need not be polyconvex in the plane.
struct Polyconvexity {
  int mapped = 0;           ///< states of the map
  int not_elliptic = 0;     ///< of these; one refutes, because rank-one convexity is necessary
  int states = 0;           ///< F0 that were tried against pairs
  int refuted = 0;          ///< those whose bounds contradict each other
  int tensile = 0;          ///< of all, those in tension
  int tensile_refuted = 0;  ///< of the refuted, those in tension
  Strain at = {};           ///< a state that refutes

  bool is_refuted() const { return not_elliptic > 0 || refuted > 0; }
};

/// The acoustic tensor over the map, and `n` states F0 of the box (evenly spread, seeded) against the whole map turned
/// by 12 angles and its mirror images in shear.
Polyconvexity polyconvexity(const Fabric& fabric, const Request& request, const std::vector<MapPoint>& map,
                            int n = 100);

Finding polyconvexity_finding(const Polyconvexity& result);

}  // namespace toile::criteria
