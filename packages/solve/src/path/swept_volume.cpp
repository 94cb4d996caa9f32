#include "path/swept_volume.hpp"

#include <set>
#include <vector>

#include "terms/follower_pressure.hpp"
#include "terms/pressure_edges.hpp"

namespace toile::solve {

namespace {

std::vector<Vec3> positions_of_nodes(const Problem& problem, const State& state) {
  std::vector<Vec3> x(problem.mesh->placed.size());
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) x[node] = node_position(problem, state, static_cast<int>(c), node);
  return x;
}

}  // namespace

double swept_volume(const Problem& problem, const State& state) {
  const std::vector<std::vector<std::uint8_t>> edges = find_pressure_edges(problem);
  const std::vector<Vec3>& placed = problem.mesh->placed;
  const std::vector<Vec3> now = positions_of_nodes(problem, state);
  std::set<int> blocks;
  for (const FollowerPressure& pressure : problem.pressures) blocks.insert(pressure.block);
  double volume = 0.0;
  for (const int b : blocks) {
    const mesh::Block& block = problem.mesh->blocks[b];
    const size_t corners = static_cast<size_t>(block.nodes_per_element);
    for (size_t e = 0; e < block.connectivity.size() / corners; ++e) {
      const int* node = &block.connectivity[e * corners];
      double before[12], after[12];
      for (size_t i = 0; i < corners; ++i)
        for (Eigen::Index d = 0; d < 3; ++d) {
          before[3 * i + static_cast<size_t>(d)] = placed[node[i]][d];
          after[3 * i + static_cast<size_t>(d)] = now[node[i]][d];
        }
      volume += pressure_on_element(block.nodes_per_element, after, 1.0, nullptr).volume -
                pressure_on_element(block.nodes_per_element, before, 1.0, nullptr).volume;
      for (size_t i = 0; i < corners; ++i) {
        const int a = node[i], next = node[(i + 1) % corners];
        if ((edges[b][e] >> i & 1U) != 0) volume -= edge_work(placed[a], placed[next], now[a], now[next]);
      }
    }
  }
  return volume;
}

}  // namespace toile::solve
