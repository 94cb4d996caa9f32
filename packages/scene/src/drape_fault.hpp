// Why a draped garment is no start: too small, a seam that stays open, nowhere on the body.
#pragma once

#include <string>

#include "toile/base/parameters.hpp"
#include "toile/body/surface.hpp"
#include "toile/drape/drape.hpp"
#include "toile/garment/garment.hpp"
#include "toile/garment/seam.hpp"

namespace toile::scene {

/// Message for the user, empty if the start can be used. `scene`: the outermost list. The garment is the draped one.
std::string drape_fault(const base::List& scene, const garment::Garment& garment, const garment::Clusters& clusters,
                        const body::Surface& body, const drape::Outcome& outcome);

}  // namespace toile::scene
