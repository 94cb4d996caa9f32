#include "mesh_geometry.hpp"

#include <Eigen/Geometry>

namespace toile::body {
namespace {

double mean_side(const TriangleMesh& mesh, const std::array<int, 3>& corners) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    sum += (mesh.vertices[corners[i]] - mesh.vertices[corners[(i + 1) % 3]]).norm();
  }
  return sum / 3.0;
}

}  // namespace

std::vector<Vec3> area_vectors(const TriangleMesh& mesh) {
  std::vector<Vec3> vectors;
  vectors.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    vectors.push_back((mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a));
  }
  return vectors;
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = mesh.vertices[t[(i + 1) % 3]] - mesh.vertices[t[i]];
      const Vec3 b = mesh.vertices[t[(i + 2) % 3]] - mesh.vertices[t[i]];
      const double weight = a.squaredNorm() * b.squaredNorm();
      if (weight > 0.0) {
        normals[t[i]] += a.cross(b) / weight;
      }
    }
  }
  for (Vec3& normal : normals) {
    normal.normalize();
  }
  return normals;
}

std::vector<double> vertex_areas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.vertices.size(), 0.0);
  const auto vectors = area_vectors(mesh);
  for (std::size_t t = 0; t < vectors.size(); ++t) {
    for (const int vertex : mesh.triangles[t]) {
      areas[vertex] += vectors[t].norm() / 6.0;
    }
  }
  return areas;
}

std::vector<double> vertex_edge_lengths(const TriangleMesh& mesh) {
  std::vector<double> sums(mesh.vertices.size(), 0.0), areas(mesh.vertices.size(), 0.0);
  const auto vectors = area_vectors(mesh);
  for (std::size_t t = 0; t < vectors.size(); ++t) {
    for (const int vertex : mesh.triangles[t]) {
      sums[vertex] += vectors[t].norm() * mean_side(mesh, mesh.triangles[t]);
      areas[vertex] += vectors[t].norm();
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (areas[i] > 0.0) sums[i] /= areas[i];
  }
  return sums;
}

double mean_edge_length(const TriangleMesh& mesh) {
  double sum = 0.0, area = 0.0;
  const auto vectors = area_vectors(mesh);
  for (std::size_t t = 0; t < vectors.size(); ++t) {
    sum += vectors[t].norm() * mean_side(mesh, mesh.triangles[t]);
    area += vectors[t].norm();
  }
  return sum / area;
}

}  // namespace toile::body
