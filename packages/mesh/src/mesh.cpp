#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

int Mesh::elements() const {
  int count = 0;
  for (const Block& block : blocks) count += block.size();
  return count;
}

std::vector<double> arc_lengths(const Mesh& mesh, const std::vector<int>& nodes) {
  std::vector<double> arc(nodes.empty() ? 0 : 1, 0.0);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    arc.push_back(arc.back() + (mesh.pattern[nodes[k]] - mesh.pattern[nodes[k - 1]]).norm());
  }
  return arc;
}

}  // namespace toile::mesh
