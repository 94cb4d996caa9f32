#include "toile/body/border.hpp"

#include "mesh_geometry.hpp"

namespace toile::body {

std::vector<char> border_vertices(const TriangleMesh& mesh) {
  std::vector<char> border(mesh.vertices.size(), 0);
  for (const MeshEdge& edge : mesh_edges(mesh.triangles)) {
    if (edge.count() == 1) {
      border[edge.a] = border[edge.b] = 1;
    }
  }
  return border;
}

}  // namespace toile::body
