#include "surface_samples.hpp"

#include <algorithm>
#include <cmath>

#include "mesh_geometry.hpp"

namespace toile::body {
namespace {

int parts_of(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(length / spacing)));
}

/// One side of a triangle.
struct Side {
  int a = 0, b = 0;  ///< vertices, a < b
  int triangle = 0;
  int opposite = 0;  ///< corner
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(mesh.triangles[t][(i + 1) % 3], mesh.triangles[t][(i + 2) % 3]);
      sides.push_back({a, b, static_cast<int>(t), i});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& x, const Side& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  return sides;
}

}  // namespace

SurfaceSamples::SurfaceSamples(const TriangleMesh& mesh, double spacing)
    : points(mesh.vertices),
      normals(vertex_normals(mesh)),
      edge_lengths(vertex_edge_lengths(mesh)),
      lattices_(mesh.triangles.size()) {
  place_on_edges(mesh, spacing);
  place_inside(mesh);
  link_lattices();
}

void SurfaceSamples::add(const Vec3& point, const Vec3& normal, double edge) {
  points.push_back(point);
  normals.push_back(normal.normalized());
  edge_lengths.push_back(edge);
}

void SurfaceSamples::place_on_edges(const TriangleMesh& mesh, double spacing) {
  for (const Side& side : sorted_sides(mesh)) {
    if (edges_.empty() || edges_.back().a != side.a || edges_.back().b != side.b) {
      const Vec3 a = points[side.a], b = points[side.b], normal_a = normals[side.a], normal_b = normals[side.b];
      const Edge edge{side.a, side.b, parts_of((b - a).norm(), spacing), size()};
      edges_.push_back(edge);
      for (int i = 1; i < edge.parts; ++i) {
        const double share = static_cast<double>(i) / edge.parts;
        add(a + share * (b - a), normal_a + share * (normal_b - normal_a),
            edge_lengths[side.a] + share * (edge_lengths[side.b] - edge_lengths[side.a]));
      }
    }
    Lattice& lattice = lattices_[side.triangle];
    lattice.corners = mesh.triangles[side.triangle];
    lattice.edges[side.opposite] = static_cast<int>(edges_.size()) - 1;
    lattice.turned[side.opposite] = lattice.corners[(side.opposite + 1) % 3] == side.b;
    lattice.parts = std::max(lattice.parts, edges_.back().parts);
  }
}

void SurfaceSamples::place_inside(const TriangleMesh& mesh) {
  for (Lattice& lattice : lattices_) {
    lattice.inside = size();
    const auto& c = lattice.corners;
    for (int i = 1; i < lattice.parts; ++i) {
      for (int j = 1; i + j < lattice.parts; ++j) {
        const Vec3 share = Vec3(i, j, lattice.parts - i - j) / lattice.parts;
        add(share[0] * mesh.vertices[c[0]] + share[1] * mesh.vertices[c[1]] + share[2] * mesh.vertices[c[2]],
            share[0] * normals[c[0]] + share[1] * normals[c[1]] + share[2] * normals[c[2]],
            share.dot(Vec3(edge_lengths[c[0]], edge_lengths[c[1]], edge_lengths[c[2]])));
      }
    }
  }
}

int SurfaceSamples::on_edge(const Lattice& lattice, int opposite, int step) const {
  const Edge& edge = edges_[lattice.edges[opposite]];
  const int along = lattice.turned[opposite] ? lattice.parts - step : step;
  const int place = (2 * along * edge.parts + lattice.parts) / (2 * lattice.parts);
  return place == 0 ? edge.a : place == edge.parts ? edge.b : edge.first + place - 1;
}

int SurfaceSamples::at(const Lattice& lattice, int i, int j) const {
  const int n = lattice.parts, k = n - i - j;
  if (i == 0) return on_edge(lattice, 0, k);
  if (j == 0) return on_edge(lattice, 1, i);
  if (k == 0) return on_edge(lattice, 2, j);
  // Rows i = 1 .. n - 2 with n - 1 - i samples each.
  return lattice.inside + (i - 1) * (n - 1) - i * (i - 1) / 2 + j - 1;
}

void SurfaceSamples::link_lattices() {
  const auto link = [this](int a, int b) {
    if (a != b) links.push_back({std::min(a, b), std::max(a, b)});
  };
  for (const Lattice& lattice : lattices_) {
    for (int i = 0; i < lattice.parts; ++i) {
      for (int j = 0; i + j < lattice.parts; ++j) {
        const int a = at(lattice, i, j), b = at(lattice, i + 1, j), c = at(lattice, i, j + 1);
        link(a, b);
        link(b, c);
        link(c, a);
      }
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
}

std::vector<SurfaceSamples::Place> SurfaceSamples::places() const {
  std::vector<Place> result(points.size());
  for (std::size_t t = 0; t < lattices_.size(); ++t) {
    const int n = lattices_[t].parts;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; i + j <= n; ++j) {
        result[at(lattices_[t], i, j)] = {static_cast<int>(t), Vec3(i, j, n - i - j) / n};
      }
    }
  }
  return result;
}

int SurfaceSamples::nearest(int triangle, const Vec3& barycentric) const {
  const Lattice& lattice = lattices_[triangle];
  const int n = lattice.parts;
  const int i = std::clamp(static_cast<int>(std::lround(barycentric[0] * n)), 0, n);
  const int j = std::clamp(static_cast<int>(std::lround(barycentric[1] * n)), 0, n - i);
  return at(lattice, i, j);
}

}  // namespace toile::body
