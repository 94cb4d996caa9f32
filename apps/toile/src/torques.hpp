#pragma once

#include <string>
#include <vector>

#include "toile/result/csv.hpp"
#include "toile/result/plot.hpp"
#include "toile/solve/problem.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::app {

/// Whether a support turns.
bool any_turns(const solve::Problem& problem);

/// Angle and torque of each support that turns, a row a step; no columns beyond step and load if none does.
result::Table torque_table(const solve::Problem& problem, const std::vector<solve::StepReport>& reports);
/// Torque over angle.
result::Plot torque_plot(const std::string& title, const result::Table& table);

}  // namespace toile::app
