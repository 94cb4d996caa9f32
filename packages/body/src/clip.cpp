#include <limits>

#include "pieces.hpp"
#include "toile/body/import.hpp"

namespace toile::body {
namespace {

bool meets(const TriangleMesh& mesh, const std::array<int, 3>& t, const Region& region) {
  const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
  const Vec3 lower = a.cwiseMin(b).cwiseMin(c);
  const Vec3 upper = a.cwiseMax(b).cwiseMax(c);
  return (lower.array() <= region.upper.array()).all() && (upper.array() >= region.lower.array()).all();
}

void keep_nearest_piece(const TriangleMesh& mesh, const Vec3& seed, std::vector<std::array<int, 3>>* triangles) {
  Pieces pieces(mesh.vertices.size(), *triangles);
  double least = std::numeric_limits<double>::infinity();
  int wanted = -1;
  for (const auto& t : *triangles) {
    const Vec3 centre = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    const double distance = (centre - seed).squaredNorm();
    if (distance < least) {
      least = distance;
      wanted = pieces.of(t);
    }
  }
  std::vector<std::array<int, 3>> kept;
  for (const auto& t : *triangles) {
    if (pieces.of(t) == wanted) {
      kept.push_back(t);
    }
  }
  triangles->swap(kept);
}

TriangleMesh compact(const TriangleMesh& mesh, const std::vector<std::array<int, 3>>& triangles) {
  TriangleMesh result;
  std::vector<int> index(mesh.vertices.size(), -1);
  for (auto t : triangles) {
    for (int& vertex : t) {
      if (index[vertex] < 0) {
        index[vertex] = static_cast<int>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[vertex]);
      }
      vertex = index[vertex];
    }
    result.triangles.push_back(t);
  }
  return result;
}

}  // namespace

TriangleMesh clip(const TriangleMesh& mesh, const Region& region) {
  std::vector<std::array<int, 3>> triangles;
  for (const auto& t : mesh.triangles) {
    if (meets(mesh, t, region)) {
      triangles.push_back(t);
    }
  }
  if (region.seed) {
    keep_nearest_piece(mesh, *region.seed, &triangles);
  }
  return compact(mesh, triangles);
}

}  // namespace toile::body
