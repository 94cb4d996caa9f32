#include "triangulate.hpp"

namespace toile::result {
namespace {

/// Nodal values followed by the mean over each quadrilateral.
template <class T>
std::vector<T> with_centres(const mesh::Mesh& garment, std::vector<T> values) {
  for (const mesh::Block& block : garment.blocks) {
    for (std::size_t i = 0; block.nodes_per_element == 4 && i < block.connectivity.size(); i += 4) {
      const auto value = [&](std::size_t k) -> const T& {
        return values[static_cast<std::size_t>(block.connectivity[i + k])];
      };
      const T centre = 0.25 * (value(0) + value(1) + value(2) + value(3));
      values.push_back(centre);
    }
  }
  return values;
}

}  // namespace

GarmentTriangles triangulate(const mesh::Mesh& garment, const std::vector<mesh::Vec3>& position) {
  GarmentTriangles result;
  result.mesh.vertices = with_centres(garment, position);
  int centre = garment.nodes();
  int element = 0;
  for (std::size_t b = 0; b < garment.blocks.size(); ++b) {
    const mesh::Block& block = garment.blocks[b];
    const auto add = [&](int first, int second, int third) {
      result.mesh.triangles.push_back({first, second, third});
      result.element.push_back(element);
      result.block.push_back(static_cast<int>(b));
    };
    for (int e = 0; e < block.size(); ++e, ++element) {
      const int* node = block.connectivity.data() + e * block.nodes_per_element;
      if (block.nodes_per_element == 3) {
        add(node[0], node[1], node[2]);
        continue;
      }
      for (int k = 0; k < 4; ++k) {
        add(node[k], node[(k + 1) % 4], centre);
      }
      ++centre;
    }
  }
  return result;
}

std::vector<double> at_vertices(const mesh::Mesh& garment, const std::vector<double>& nodal) {
  return with_centres(garment, nodal);
}

std::vector<mesh::Vec3> at_vertices(const mesh::Mesh& garment, const std::vector<mesh::Vec3>& nodal) {
  return with_centres(garment, nodal);
}

}  // namespace toile::result
