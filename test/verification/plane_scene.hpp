#pragma once

#include <Teuchos_ParameterList.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "toile/run/session.hpp"
#include "verification/mixed_problem.hpp"

namespace toile::test {

/// One row of a file of test/data/plane_stress whose first column is the material: its numbers by column title.
struct PlaneCase {
  std::string material;  ///< type of the fabric
  std::map<std::string, double> value;

  double operator[](const std::string& title) const { return value.at(title); }
};

/// All rows of "cook" or "strips".
std::vector<PlaneCase> plane_cases(const std::string& file);

/// Quadrilaterals of a flat panel, graded towards all four sides (1: uniform).
struct PlaneMesh {
  int across = 8, along = 8;
  double grading = 1.0;
};

/// Cook's membrane: 48 x 44 x 16 mm, left side clamped, dead shear force along the right side; material, wale and force
/// are those of the row.
Teuchos::ParameterList cook_list(const PlaneCase& row, const PlaneMesh& mesh);

/// Strip 150 x 50 mm along x, ends "left" and "right" clamped, pulled along x; material, wale and stretch are the
/// row's.
Teuchos::ParameterList strip_list(const PlaneCase& row, const PlaneMesh& mesh);

/// A scene and what it reported at each accepted step, on all ranks of MPI's world.
struct PlaneRun {
  std::unique_ptr<run::Session> session;
  const scene::Scene* scene = nullptr;
  std::unique_ptr<MixedProblem> mixed;  ///< what was computed instead of the scene's own problem, or null
  std::vector<solve::StepReport> reports;
  std::vector<solve::State> states;

  /// Of the last state, mm. Without seams every node is its own cluster.
  solve::Vec3 displacement(int node) const;
  const std::vector<int>& edge(const std::string& name) const;
  /// Reaction of a support, N.
  solve::Vec3 reaction(const std::string& support, size_t step) const;
  size_t last() const { return reports.size() - 1; }
};

/// The undamped state at the end of the stage that ends at a load.
size_t final_step(const PlaneRun& run, double load);

PlaneRun run(const base::List& list);
PlaneRun run(const Teuchos::ParameterList& list);
/// A scene of input/, as it is.
PlaneRun run_shipped(const std::string& file);

/// How a panel is meshed freely.
struct FreeMeshing {
  std::string kind = "quadrilaterals";  ///< or "triangles" or "mixed"
  double size = 4.0;                    ///< mm
  std::vector<double> corners = {};     ///< x, y, x, y, ... where it is finer
  double corner_size = 1.0;             ///< mm, there
};

/// Runs the scene with its panel "sheet" meshed freely; a mixed mesh on one rank only.
PlaneRun run_freely(Teuchos::ParameterList list, const FreeMeshing& meshing);

}  // namespace toile::test
