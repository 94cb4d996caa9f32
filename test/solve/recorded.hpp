// A simulation with the reports and states of its steps, and the message of one that fails.
#pragma once

#include "toile/base/error.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::test {

struct Recorded {
  solve::Simulation simulation;
  std::vector<solve::StepReport> reports;
  std::vector<solve::State> states;  ///< of the same steps

  explicit Recorded(const solve::Problem& problem, const solve::SolverOptions& solver = {})
      : simulation(problem, solver) {
    simulation.observe([this](const solve::StepReport& r, const solve::State& state) {
      reports.push_back(r);
      states.push_back(state);
    });
  }
  const solve::StepReport& last() const { return reports.back(); }
};

inline std::string failure_of(solve::Simulation& simulation, const solve::StageOptions& options) {
  try {
    simulation.run(options);
  } catch (const base::SolveError& error) {
    return error.what();
  }
  return "no failure";
}

}  // namespace toile::test
