#pragma once

#include <string>
#include <vector>

#include "toile/scene/scene.hpp"
#include "toile/solve/fields.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::run {

/// Texts about layers that are told wrongly, so that their pressures are wrong: panels that lie over each other on more
/// than 5 % of the area of either, without "over"; and panels that lie beside what their "over" names. Only fabric that
/// touches counts.
std::vector<std::string> overlap_faults(const scene::Scene& scene, const solve::Fields& fields,
                                        const solve::StepReport& report);

}  // namespace toile::run
