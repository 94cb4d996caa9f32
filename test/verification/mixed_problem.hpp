#pragma once

#include "toile/scene/scene.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::test {

/// A problem of quadrilaterals of which about every second one, as chance has it, is cut in two along its shorter
/// diagonal: triangles and quadrilaterals of the same fabric and kind (membrane, shell) on the same nodes. One rank.
class MixedProblem {
 public:
  explicit MixedProblem(const solve::Problem& whole);
  MixedProblem(const MixedProblem&) = delete;
  MixedProblem& operator=(const MixedProblem&) = delete;

  solve::Problem problem;
  /// Takes it through the stages of the scene that it was made of. No session does: its scene has another mesh.
  solve::SolveStatistics run(const scene::Scene& scene, const solve::Simulation::Observer& observer) const;
  int triangles() const;  ///< elements with three nodes

 private:
  mesh::Mesh mesh_;
};

}  // namespace toile::test
