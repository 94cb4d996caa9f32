#include "vertex_normals.hpp"

#include <Eigen/Geometry>

namespace toile::result {

std::vector<body::Vec3> vertex_normals(const body::TriangleMesh& mesh) {
  std::vector<body::Vec3> normals(mesh.vertices.size(), body::Vec3::Zero());
  const auto vertex = [&](int i) -> const body::Vec3& { return mesh.vertices[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : mesh.triangles) {
    const body::Vec3 normal = (vertex(b) - vertex(a)).cross(vertex(c) - vertex(a));
    for (const int i : {a, b, c}) normals[static_cast<std::size_t>(i)] += normal;
  }
  for (body::Vec3& normal : normals) normal.normalize();
  return normals;
}

}  // namespace toile::result
