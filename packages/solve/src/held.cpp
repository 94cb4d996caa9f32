#include "held.hpp"

#include <cmath>

#include "toile/base/error.hpp"

namespace toile::solve {

namespace {

std::vector<std::array<HeldComponent, 3>> held_positions(const Problem& problem,
                                                         const std::set<std::string>& released) {
  std::vector<int> cluster_of(problem.mesh->nodes());
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  std::vector<std::array<HeldComponent, 3>> held(problem.clusters.size());
  for (size_t s = 0; s < problem.supports.size(); ++s) {
    const Support& support = problem.supports[s];
    if (released.count(support.name)) continue;
    for (const int node : support.nodes)
      for (int i = 0; i < 3; ++i) {
        if (!support.held[i]) continue;
        HeldComponent& h = held[cluster_of[node]][i];
        if (h.held && h.displacement != support.displacement[i])
          throw base::InputError("supports contradict each other: support \"" + support.name + "\" moves node " +
                                 std::to_string(node) + " by " + std::to_string(support.displacement[i]) +
                                 " mm in direction " + "xyz"[i] + ", another support by " +
                                 std::to_string(h.displacement) + " mm");
        h = {true, problem.mesh->placed[problem.clusters[cluster_of[node]].front()][i], support.displacement[i],
             static_cast<int>(s)};
      }
  }
  return held;
}

/// Which rotations the supports hold: all of a clamp, and those out of a plane of symmetry.
std::vector<std::array<bool, 2>> held_rotations(const Problem& problem, const State& state,
                                                const std::set<std::string>& released) {
  if (state.frame.empty()) return {};
  std::vector<std::array<bool, 2>> held;
  for (const bool is_shell : shell_nodes(problem)) held.push_back({!is_shell, !is_shell});
  constexpr double along = 0.9;  // a tangent that start_frames laid along the normal of the plane
  for (const Support& support : problem.supports) {
    if (support.director == DirectorSupport::free || released.count(support.name)) continue;
    for (const int node : support.nodes)
      for (Eigen::Index k = 0; k < 2; ++k)
        for (Eigen::Index d = 0; d < 3; ++d)
          if (support.director == DirectorSupport::held ||
              (support.held[static_cast<size_t>(d)] && std::abs(state.frame[node](k, d)) > along))
            held[node][static_cast<size_t>(k)] = true;
  }
  return held;
}

}  // namespace

Held held_by_supports(const Problem& problem, const State& state, const std::set<std::string>& released) {
  return {held_positions(problem, released), held_rotations(problem, state, released)};
}

}  // namespace toile::solve
