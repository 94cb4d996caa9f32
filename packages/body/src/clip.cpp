#include <algorithm>
#include <limits>
#include <map>

#include "meets.hpp"
#include "pieces.hpp"
#include "toile/body/import.hpp"

namespace toile::body {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

/// Connected piece of each triangle, as a number. Triangles are neighbours through an edge that meets the region: two
/// legs that share a vertex just above it are not one piece.
std::vector<int> pieces_of(const TriangleMesh& mesh, const Triangles& triangles, const Region& region, double margin) {
  std::map<std::array<int, 2>, int> shared;
  Triangles edges;
  int count = 0;
  for (const auto& t : triangles) {
    std::array<int, 3> numbers{};
    for (int i = 0; i < 3; ++i) {
      const std::array<int, 2> edge{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])};
      const bool joins = meets(mesh, edge, region, margin);
      numbers[i] = joins ? shared.try_emplace(edge, count).first->second : count;
      ++count;
    }
    edges.push_back(numbers);
  }
  Pieces pieces(count, edges);
  std::vector<int> result;
  for (const auto& numbers : edges) {
    result.push_back(pieces.of(numbers));
  }
  return result;
}

Triangles chosen(const Triangles& triangles, const std::vector<int>& piece, int wanted) {
  Triangles result;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (piece[t] == wanted) {
      result.push_back(triangles[t]);
    }
  }
  return result;
}

/// Of `triangles`, the connected piece that holds the triangle nearest to the seed.
Triangles nearest_piece(const TriangleMesh& mesh, const Triangles& triangles, const Region& region) {
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    const Vec3 centre = (mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3.0;
    const double distance = (centre - *region.seed).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  const std::vector<int> piece = pieces_of(mesh, triangles, region, 0.0);
  return chosen(triangles, piece, piece[nearest]);
}

/// `piece` and what is connected to it within the margin, but not through other triangles inside the bounds.
Triangles continued(const TriangleMesh& mesh, const Triangles& piece, const Region& region) {
  Triangles triangles = piece;
  for (const auto& t : mesh.triangles) {
    if (meets(mesh, t, region, region.margin) && !meets(mesh, t, region, 0.0)) {
      triangles.push_back(t);
    }
  }
  const std::vector<int> number = pieces_of(mesh, triangles, region, region.margin);
  return chosen(triangles, number, number.front());
}

TriangleMesh compact(const TriangleMesh& mesh, const Triangles& triangles) {
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
  // Without a seed there is no piece to continue.
  const double margin = region.seed ? 0.0 : region.margin;
  Triangles triangles;
  for (const auto& t : mesh.triangles) {
    if (meets(mesh, t, region, margin)) {
      triangles.push_back(t);
    }
  }
  if (region.seed && !triangles.empty()) {
    triangles = continued(mesh, nearest_piece(mesh, triangles, region), region);
  }
  return compact(mesh, triangles);
}

}  // namespace toile::body
