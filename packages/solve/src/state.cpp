#include "toile/solve/problem.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::solve {

Vec3 node_position(const Problem& problem, const State& state, int cluster, int node) {
  const int master = problem.clusters[cluster].front();
  const Vec3 separation = problem.mesh->placed[node] - problem.mesh->placed[master];
  return state.position[cluster] + (1.0 - state.seam) * separation;
}

State placed_state(const Problem& problem) {
  State state;
  for (const std::vector<int>& members : problem.clusters)
    state.position.push_back(problem.mesh->placed[members.front()]);
  state.contact_force.assign(problem.clusters.size(), 0.0);
  state.offset.assign(problem.clusters.size(), 0.0);
  return state;
}

Vec3 ForceBalance::sum() const {
  Vec3 total = contact + load + damping;
  for (const Vec3& reaction : support) total += reaction;
  return total;
}

}  // namespace toile::solve
