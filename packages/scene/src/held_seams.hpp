#pragma once

#include "toile/scene/scene.hpp"

namespace toile::scene {

/// Messages on supports that hold a node which a seam would move by more than half the side of an element: sewn nodes
/// meet where the first one is placed, wherever else a support wants the other one to stay. Supports that are released
/// before a seam closes are left out. `list`: of the scene.
std::vector<std::string> held_seam_errors(const Scene& scene, const base::List& list);

/// Held nodes that seams move by less than that, and that strain the fabric beside them by more than a hundredth.
std::vector<std::string> held_seam_warnings(const Scene& scene);

}  // namespace toile::scene
