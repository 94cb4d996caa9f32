#pragma once

#include <string>
#include <vector>

#include "toile/result/csv.hpp"
#include "toile/run/record.hpp"

namespace toile::run {

/// Columns step and load, a row a step: how every table over the steps begins.
result::Table step_table(const std::vector<solve::StepReport>& reports);

/// A column for each distance of the scene's output.
void add_distances(result::Table& table, const Record& record);

}  // namespace toile::run
