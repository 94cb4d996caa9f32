#include "toile/crossing/crossings.hpp"

namespace toile::crossing {

bool available() {
  return false;
}

Crossings find_crossings(const mesh::Mesh& mesh, const std::vector<std::vector<int>>&, const std::vector<mesh::Vec3>&) {
  return {{}, std::vector<double>(static_cast<std::size_t>(mesh.elements()), 0.0)};
}

}  // namespace toile::crossing
