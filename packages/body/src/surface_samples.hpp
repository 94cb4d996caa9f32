#pragma once

#include <array>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::body {

/// Points that cover the facets of a mesh, and which of them are neighbours on it. Their first are the mesh's vertices;
/// no point of a facet is further from a sample of that facet than 0.58 spacings.
class SurfaceSamples {
 public:
  SurfaceSamples(const TriangleMesh& mesh, double spacing);

  int size() const { return static_cast<int>(points.size()); }
  /// The sample of the triangle's lattice that is nearest to the point with those barycentric coordinates.
  int nearest(int triangle, const Vec3& barycentric) const;

  /// A place on a facet.
  struct Place {
    int triangle = -1;
    Vec3 barycentric = Vec3::Zero();
  };
  /// Where each sample lies, on one of its facets; triangle -1: a vertex that no triangle uses.
  std::vector<Place> places() const;

  std::vector<Vec3> points;               ///< mm
  std::vector<Vec3> normals;              ///< unit, interpolated from the vertex normals; zero for unused vertices
  std::vector<double> edge_lengths;       ///< mean length of the edges of the facets there, interpolated alike, mm
  std::vector<std::array<int, 2>> links;  ///< pairs of neighbours, smaller index first; each once

 private:
  struct Lattice {
    std::array<int, 3> corners{};  ///< vertices
    std::array<int, 3> edges{};    ///< edge opposite to each corner
    std::array<bool, 3> turned{};  ///< that edge runs from its larger vertex to the smaller one
    int parts = 1;                 ///< of each side
    int inside = 0;                ///< first sample inside
  };
  struct Edge {
    int a = 0, b = 0;  ///< vertices, a < b
    int parts = 1;
    int first = 0;  ///< first sample between its ends
  };

  void place_on_edges(const TriangleMesh& mesh, double spacing);
  void place_inside(const TriangleMesh& mesh);
  void add(const Vec3& point, const Vec3& normal, double edge);
  void link_lattices();
  int on_edge(const Lattice& lattice, int opposite, int step) const;
  /// Sample at i parts from corner 1 and 2 towards corner 0 and j towards corner 1.
  int at(const Lattice& lattice, int i, int j) const;

  std::vector<Lattice> lattices_;
  std::vector<Edge> edges_;
};

}  // namespace toile::body
