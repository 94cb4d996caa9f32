#pragma once

#include <vector>

#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::app {

/// Columns step and load, a row a step: how every table over the steps begins.
result::Table step_table(const std::vector<solve::StepReport>& reports);

/// Forces on the garment by component: of the body, of each support, of loads.
result::Table reaction_table(const solve::Problem& problem, const std::vector<solve::StepReport>& reports);

/// `displacement`: [point][step], mm.
result::Table point_table(const scene::Output& output, const std::vector<solve::StepReport>& reports,
                          const std::vector<std::vector<solve::Vec3>>& displacement);

/// `distances`: [curve][step], mm.
result::Table distance_table(const scene::Output& output, const std::vector<solve::StepReport>& reports,
                             const std::vector<std::vector<double>>& distances);

/// Stretch and force of each force curve, and the distances beside them.
result::Table force_table(const scene::Scene& scene, const std::vector<solve::StepReport>& reports,
                          const std::vector<std::vector<double>>& distances);
result::Plot force_plot(const scene::Scene& scene, const std::vector<solve::StepReport>& reports);

}  // namespace toile::app
