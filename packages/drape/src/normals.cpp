#include "normals.hpp"

#include <Eigen/Geometry>

namespace toile::drape {

std::vector<mesh::Vec3> nodal_normals(const mesh::Mesh& mesh) {
  std::vector<mesh::Vec3> normals(mesh.placed.size(), mesh::Vec3::Zero());
  for (const mesh::Block& block : mesh.blocks) {
    const std::size_t per = static_cast<std::size_t>(block.nodes_per_element);
    for (std::size_t e = 0; e < block.connectivity.size(); e += per)
      for (std::size_t i = 0; i < per; ++i) {
        const int n = block.connectivity[e + i];
        const mesh::Vec3 &at = mesh.placed[n], &next = mesh.placed[block.connectivity[e + (i + 1) % per]],
                         &last = mesh.placed[block.connectivity[e + (i + per - 1) % per]];
        normals[n] += (next - at).cross(last - at);
      }
  }
  for (std::size_t n = 0; n < normals.size(); ++n)
    normals[n] = normals[n].norm() > 0.0 ? normals[n].normalized() : mesh.normal[n];
  return normals;
}

}  // namespace toile::drape
