#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// An undirected edge (smaller index first) with the facets that use it, in that direction and in the other.
struct MeshEdge {
  int a = 0;
  int b = 0;
  int forward = 0;   ///< facets that run from a to b
  int backward = 0;  ///< facets that run from b to a
  int count() const { return forward + backward; }
};

/// All edges, sorted by (a, b). `polygons`: any ranges of vertex indices.
template <class Polygons>
std::vector<MeshEdge> mesh_edges(const Polygons& polygons) {
  std::vector<MeshEdge> all;
  for (const auto& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const int a = static_cast<int>(polygon[i]);
      const int b = static_cast<int>(polygon[(i + 1) % polygon.size()]);
      all.push_back(a < b ? MeshEdge{a, b, 1, 0} : MeshEdge{b, a, 0, 1});
    }
  }
  std::sort(all.begin(), all.end(),
            [](const MeshEdge& x, const MeshEdge& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  std::vector<MeshEdge> edges;
  for (const MeshEdge& edge : all) {
    if (!edges.empty() && edges.back().a == edge.a && edges.back().b == edge.b) {
      edges.back().forward += edge.forward;
      edges.back().backward += edge.backward;
    } else {
      edges.push_back(edge);
    }
  }
  return edges;
}

/// (b - a) x (c - a) of each triangle: twice the area times the normal.
std::vector<Vec3> area_vectors(const TriangleMesh& mesh);

/// Unit vertex normals by Max's weights, sum (a x b)/(|a|^2 |b|^2): exact on a sphere (Max, J. Graphics Tools 4 (1999)
/// 1). Zero for unused vertices.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh);

/// A third of the area of the adjacent facets, mm^2.
std::vector<double> vertex_areas(const TriangleMesh& mesh);

/// Mean length of the edges of the adjacent facets, weighted by their area, mm. Zero for unused vertices.
std::vector<double> vertex_edge_lengths(const TriangleMesh& mesh);

/// mm, weighted by the area of the facets: the many small facets of a hand or a foot must not speak for the limb.
double mean_edge_length(const TriangleMesh& mesh);

}  // namespace toile::body
