#pragma once

#include <map>
#include <string>
#include <vector>

#include "toile/scene/scene.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::test {

/// Columns of a file of test/data, by title; lines that start with # are left out.
std::map<std::string, std::vector<double>> read_table(const std::string& file);

/// The load and the displacements of a scene's points at each accepted step.
struct PointHistory {
  std::vector<double> load;
  std::map<std::string, std::vector<solve::Vec3>> displacement;  ///< mm
  std::vector<solve::StepReport> reports;
  std::vector<std::string> notes;
  solve::SolveStatistics statistics;

  /// The step whose load is this within 1e-9.
  size_t step_at(double wanted) const;
};

/// Runs all stages of a scene, on all ranks of MPI's world. `mixed`: with about every second quadrilateral cut in two
/// (see MixedProblem), on one rank.
PointHistory follow_points(const base::List& list, bool mixed = false);

/// A scene of input/, as it is.
base::List shipped_scene(const std::string& file);

}  // namespace toile::test
