#include "equilibrium/diagonal.hpp"

#include "equilibrium/stencils.hpp"

namespace toile::solve {

Diagonal::Diagonal(const Layout& layout, const Graph& graph) : layout_(layout) {
  for (int c = 0; c < layout.owned_clusters; ++c) {
    std::array<std::array<std::int64_t, 3>, 3> places{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) places[i][j] = place_of(graph, layout.dof[c][i], layout.dof[c][j]);
    positions.push_back(places);
  }
  for (size_t n = 0; n < layout.rotation.size(); ++n) {
    std::array<std::int64_t, 2> places = {-1, -1};
    if (layout.node_cluster[n] < layout.owned_clusters)
      for (size_t k = 0; k < 2; ++k) places[k] = place_of(graph, layout.rotation[n][k], layout.rotation[n][k]);
    rotations.push_back(places);
  }
}

void Diagonal::add(size_t cluster, const Eigen::Matrix3d& block, double* values) const {
  const int c = static_cast<int>(cluster);
  const Eigen::Matrix3d components =
      layout_.is_turned(c) ? (layout_.basis[c].along.transpose() * block * layout_.basis[c].along).eval() : block;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if (positions[cluster][a][b] >= 0) values[positions[cluster][a][b]] += components(a, b);
}

void Diagonal::add_mass(double factor, const std::vector<double>& mass, double* values) const {
  for (size_t c = 0; c < positions.size(); ++c)
    for (int i = 0; i < 3; ++i)
      if (positions[c][i][i] >= 0) values[positions[c][i][i]] += factor * mass[c];
}

}  // namespace toile::solve
