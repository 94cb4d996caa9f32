#include "toile/mesh/mesh.hpp"

#include <algorithm>

#include <cmath>

namespace toile::mesh {

int Mesh::elements() const {
  int count = 0;
  for (const Block& block : blocks) count += block.size();
  return count;
}

int Mesh::panel_index(int node) const {
  const auto after = std::upper_bound(panels.begin(), panels.end(), node,
                                      [](int n, const MeshedPanel& panel) { return n < panel.first; });
  return static_cast<int>(after - panels.begin()) - 1;
}

double pattern_area(const Mesh& mesh, const Block& block, std::size_t element) {
  const auto per = static_cast<std::size_t>(block.nodes_per_element);
  const auto corner = [&](std::size_t i) { return mesh.pattern[block.connectivity[element * per + i % per]]; };
  double twice = 0.0;
  for (std::size_t i = 0; i < per; ++i) {
    twice += corner(i).x() * corner(i + 1).y() - corner(i + 1).x() * corner(i).y();
  }
  return 0.5 * std::abs(twice);
}

std::vector<double> arc_lengths(const Mesh& mesh, const std::vector<int>& nodes) {
  std::vector<double> arc(nodes.empty() ? 0 : 1, 0.0);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    arc.push_back(arc.back() + (mesh.pattern[nodes[k]] - mesh.pattern[nodes[k - 1]]).norm());
  }
  return arc;
}

}  // namespace toile::mesh
