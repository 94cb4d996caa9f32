#pragma once

#include <string>
#include <vector>

#include "toile/result/csv.hpp"
#include "toile/result/field_name.hpp"
#include "toile/result/plot.hpp"
#include "toile/solve/problem.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::app {

/// Names of the histories of the torques, "torque_" and the support's name (N mm): one a support that turns.
std::vector<result::FieldName> torque_names(const solve::Problem& problem);
/// The torques of a step, in the order of the names.
std::vector<double> torques(const solve::Problem& problem, const solve::StepReport& report);

/// Angle and torque of each support that turns, a row a step; no columns beyond step and load if none does.
result::Table torque_table(const solve::Problem& problem, const std::vector<solve::StepReport>& reports);
/// Torque over angle.
result::Plot torque_plot(const std::string& title, const result::Table& table);

}  // namespace toile::app
