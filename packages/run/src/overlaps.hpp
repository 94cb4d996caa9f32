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

/// The first of these, of panels that start so within 5 mm of the body. `fields`: of the start.
std::vector<std::string> overlaps_of_start(const scene::Scene& scene, const solve::Fields& fields);

}  // namespace toile::run
