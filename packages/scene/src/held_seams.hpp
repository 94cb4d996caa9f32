#pragma once

#include "toile/scene/scene.hpp"

namespace toile::scene {

/// Refuses a support that holds a node which a seam would move: sewn nodes meet where the first one is placed, wherever
/// else a support wants the other one to stay. Supports that are released before a seam closes are left out.
/// Throws base::InputError with the names of both.
void check_held_seams(const base::List& scene, const garment::Garment& garment, const solve::Problem& problem);

}  // namespace toile::scene
