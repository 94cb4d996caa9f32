#include "toile/mesh/mesh.hpp"

namespace toile::mesh {

int Mesh::elements() const {
  int count = 0;
  for (const Block& block : blocks) count += block.size();
  return count;
}

}  // namespace toile::mesh
