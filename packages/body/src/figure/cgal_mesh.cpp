#include "figure/cgal_mesh.hpp"

#include "toile/base/error.hpp"

namespace toile::body {

CgalMesh cgal_mesh(const TriangleMesh& mesh) {
  CgalMesh result;
  for (const Vec3& v : mesh.vertices) {
    result.add_vertex(cgal_point(v));
  }
  for (const auto& t : mesh.triangles) {
    const auto corner = [](int i) { return CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(i)); };
    if (result.add_face(corner(t[0]), corner(t[1]), corner(t[2])) == CgalMesh::null_face()) {
      throw base::InputError("the facets do not form a surface");
    }
  }
  return result;
}

TriangleMesh triangles_of(const CgalMesh& mesh) {
  TriangleMesh result;
  std::vector<int> number(mesh.num_vertices() + mesh.number_of_removed_vertices(), -1);
  for (const auto v : mesh.vertices()) {
    number[v.idx()] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(to_vec(mesh.point(v)));
  }
  for (const auto f : mesh.faces()) {
    std::array<int, 3> corners{};
    int i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      corners[i++] = number[v.idx()];
    }
    result.triangles.push_back(corners);
  }
  return result;
}

}  // namespace toile::body
