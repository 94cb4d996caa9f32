#include "toile/result/body_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "toile/body/triangle_tree.hpp"
#include "triangulate.hpp"

namespace toile::result {
namespace {

using body::Vec3;

/// Unit normals of the vertices, weighted by the area of their triangles.
std::vector<Vec3> vertex_normals(const body::TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
  const auto vertex = [&](int i) -> const Vec3& { return mesh.vertices[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = (vertex(b) - vertex(a)).cross(vertex(c) - vertex(a));
    for (const int i : {a, b, c}) {
      normals[static_cast<std::size_t>(i)] += normal;
    }
  }
  for (Vec3& normal : normals) {
    normal.normalize();
  }
  return normals;
}

/// Place on the garment that may lie over a vertex of the body.
struct Match {
  std::size_t vertex;
  body::TriangleTree::Hit hit;
  int block;
  double agreement;  ///< cosine between the normals
};

/// Value at a place inside a triangle of the garment.
double interpolate(const std::array<int, 3>& triangle, const Vec3& weights, const std::vector<double>& values) {
  double result = 0.0;
  for (int k = 0; k < 3; ++k) {
    result += weights[k] * values[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
  }
  return result;
}

/// The closest point lies along the garment's normal; beyond a free edge it lies sideways.
bool faces(const body::TriangleTree::Hit& hit, const Vec3& vertex) {
  constexpr double smallest_cosine = 0.9;
  const double along = std::abs(hit.pseudo_normal.dot(hit.point - vertex));
  return hit.distance < 1e-9 || along >= smallest_cosine * hit.distance;
}

/// Places that are close enough and face a vertex, whichever side of the panel they show.
std::vector<Match> candidates(const GarmentTriangles& garment, const std::vector<double>& gap,
                              const body::TriangleMesh& body, double limit) {
  const std::vector<Vec3> normals = vertex_normals(body);
  const body::TriangleTree tree(garment.mesh);
  const double reach = limit + std::max(0.0, *std::max_element(gap.begin(), gap.end()));
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : garment.mesh.vertices) {
    box.extend(vertex);
  }
  std::vector<Match> matches;
  for (std::size_t i = 0; i < body.vertices.size(); ++i) {
    if (box.exteriorDistance(body.vertices[i]) > reach) {
      continue;
    }
    const body::TriangleTree::Hit hit = tree.closest(body.vertices[i]);
    const auto t = static_cast<std::size_t>(hit.triangle);
    const double local_gap = std::max(0.0, interpolate(garment.mesh.triangles[t], hit.barycentric, gap));
    if (hit.distance <= limit + local_gap && faces(hit, body.vertices[i])) {
      matches.push_back({i, hit, garment.block[t], normals[i].dot(hit.pseudo_normal)});
    }
  }
  return matches;
}

}  // namespace

std::vector<double> map_to_body(const mesh::Mesh& garment, const std::vector<mesh::Vec3>& position,
                                const std::vector<double>& values, const std::vector<double>& gap,
                                const body::TriangleMesh& body, const BodyMapOptions& options) {
  std::vector<double> result(body.vertices.size(), 0.0);
  if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0.0; })) {
    return result;  // before the garment touches the body there is nothing to search for
  }
  const GarmentTriangles triangles = triangulate(garment, position);
  const std::vector<double> vertex_values = at_vertices(garment, values);
  const std::vector<Match> matches = candidates(triangles, at_vertices(garment, gap), body, options.limit);
  std::vector<double> side(garment.blocks.size(), 0.0);
  for (const Match& match : matches) {
    side[static_cast<std::size_t>(match.block)] += match.agreement;
  }
  for (const Match& match : matches) {
    const double sign = side[static_cast<std::size_t>(match.block)] < 0.0 ? -1.0 : 1.0;
    if (sign * match.agreement >= options.agreement) {
      const auto& triangle = triangles.mesh.triangles[static_cast<std::size_t>(match.hit.triangle)];
      result[match.vertex] = interpolate(triangle, match.hit.barycentric, vertex_values);
    }
  }
  return result;
}

}  // namespace toile::result
