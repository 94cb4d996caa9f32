#pragma once

#include <string>
#include <utility>
#include <vector>

namespace toile::solve {

/// Name and description of every kind of linear solver (linear_solver.hpp, whose libraries take long to read).
std::vector<std::pair<std::string, std::string>> linear_solver_texts();

}  // namespace toile::solve
