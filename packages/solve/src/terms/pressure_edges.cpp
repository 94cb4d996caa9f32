#include "terms/pressure_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

namespace toile::solve {

namespace {

std::vector<double> pressures(const Problem& problem) {
  std::vector<double> of_block(problem.mesh->blocks.size(), 0.0);
  for (const FollowerPressure& pressure : problem.pressures) of_block[pressure.block] += pressure.pressure;
  return of_block;
}

/// Calls visit(block, element, corner, cluster at the corner, cluster at the next) for the edges of the loaded panels.
template <class F>
void for_each_edge(const Problem& problem, const std::vector<double>& pressure, const F& visit) {
  std::vector<int> cluster_of(problem.mesh->nodes());
  for (size_t c = 0; c < problem.clusters.size(); ++c)
    for (const int node : problem.clusters[c]) cluster_of[node] = static_cast<int>(c);
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) {
    const mesh::Block& block = problem.mesh->blocks[b];
    const size_t corners = static_cast<size_t>(block.nodes_per_element);
    for (size_t i = 0; i < block.connectivity.size() && pressure[b] != 0.0; ++i) {
      const size_t element = i / corners, corner = i % corners;
      const int next = block.connectivity[element * corners + (corner + 1) % corners];
      visit(b, element, corner, cluster_of[block.connectivity[i]], cluster_of[next]);
    }
  }
}

}  // namespace

std::vector<std::vector<std::uint8_t>> find_pressure_edges(const Problem& problem) {
  const std::vector<double> pressure = pressures(problem);
  std::map<std::pair<int, int>, double> sum;  // of the pressures along an edge from its smaller cluster to its larger
  for_each_edge(problem, pressure, [&](size_t b, size_t, size_t, int from, int to) {
    (from < to ? sum[{from, to}] : sum[{to, from}]) += from < to ? pressure[b] : -pressure[b];
  });
  std::vector<std::vector<std::uint8_t>> edges;
  for (const mesh::Block& block : problem.mesh->blocks)
    edges.emplace_back(block.connectivity.size() / static_cast<size_t>(block.nodes_per_element), std::uint8_t{0});
  for_each_edge(problem, pressure, [&](size_t b, size_t element, size_t corner, int from, int to) {
    if (sum[{std::min(from, to), std::max(from, to)}] != 0.0)
      edges[b][element] = static_cast<std::uint8_t>(edges[b][element] | (1U << corner));
  });
  return edges;
}

double edge_work(const Vec3& a0, const Vec3& b0, const Vec3& a, const Vec3& b) {
  const Vec3 da = a - a0, db = b - b0;
  return b0.cross(a0).dot(da + db) / 6.0 - da.dot((a0 + b0).cross(db)) / 12.0;
}

Eigen::Matrix3d edge_stiffness(const Vec3& a, const Vec3& b) {
  const Vec3 v = -(a + b) / 12.0;
  Eigen::Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

}  // namespace toile::solve
