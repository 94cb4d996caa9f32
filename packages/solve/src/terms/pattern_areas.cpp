#include "terms/pattern_areas.hpp"

#include <string>

#include "toile/element/element.hpp"

namespace toile::solve {

std::vector<double> pattern_areas(const mesh::Mesh& mesh, const mesh::Block& block) {
  std::vector<double> pattern, areas(block.connectivity.size());
  for (const int node : block.connectivity)
    pattern.insert(pattern.end(), {mesh.pattern[node][0], mesh.pattern[node][1]});
  element::Batch batch;
  batch.n = block.size();
  batch.pattern = pattern.data();
  element::find("membrane" + std::to_string(block.nodes_per_element))->reference_areas(batch, areas.data());
  return areas;
}

}  // namespace toile::solve
