#include "toile/body/triangle_tree.hpp"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <iterator>
#include <map>

#include "mesh_geometry.hpp"

namespace toile::body {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Iterator = std::vector<Triangle>::const_iterator;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Iterator>>>;

Kernel::Point_3 to_cgal(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}
Vec3 from_cgal(const Kernel::Point_3& p) {
  return {p.x(), p.y(), p.z()};
}

double corner_angle(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3 barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double scale = 1.0 / normal.squaredNorm();
  const double u = (c - b).cross(p - b).dot(normal) * scale;
  const double v = (a - c).cross(p - c).dot(normal) * scale;
  return {u, v, 1.0 - u - v};
}

}  // namespace

struct TriangleTree::Data {
  TriangleMesh mesh;
  std::vector<Triangle> facets;  ///< those of non-zero area
  std::vector<int> original;     ///< their index in the mesh
  Tree tree;
  std::vector<Vec3> facet_normals;
  std::vector<Vec3> vertex_pseudo_normals;               ///< weighted by the corner angles
  std::vector<std::array<Vec3, 3>> edge_pseudo_normals;  ///< of the edge opposite to each corner

  void build_normals();
  Vec3 pseudo_normal(int triangle, const Vec3& weights) const;
};

void TriangleTree::Data::build_normals() {
  facet_normals = area_vectors(mesh);
  vertex_pseudo_normals.assign(mesh.vertices.size(), Vec3::Zero());
  std::map<std::pair<int, int>, Vec3> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    facet_normals[t].normalize();
    const auto& corners = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const int j = corners[(i + 1) % 3];
      const int k = corners[(i + 2) % 3];
      const Vec3& p = mesh.vertices[corners[i]];
      vertex_pseudo_normals[corners[i]] += corner_angle(mesh.vertices[j] - p, mesh.vertices[k] - p) * facet_normals[t];
      edges.try_emplace(std::minmax(j, k), Vec3::Zero()).first->second += facet_normals[t];
    }
  }
  edge_pseudo_normals.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const auto edge = std::minmax(mesh.triangles[t][(i + 1) % 3], mesh.triangles[t][(i + 2) % 3]);
      edge_pseudo_normals[t][i] = edges.at(edge);
    }
  }
}

Vec3 TriangleTree::Data::pseudo_normal(int triangle, const Vec3& weights) const {
  constexpr double on_edge = 1e-9;
  int zeros = 0;
  int zero = 0;
  int corner = 0;
  for (int i = 0; i < 3; ++i) {
    if (weights[i] < on_edge) {
      ++zeros;
      zero = i;
    } else {
      corner = i;
    }
  }
  if (zeros == 0) {
    return facet_normals[triangle];
  }
  const Vec3& sum =
      zeros == 1 ? edge_pseudo_normals[triangle][zero] : vertex_pseudo_normals[mesh.triangles[triangle][corner]];
  return sum.normalized();
}

TriangleTree::TriangleTree(const TriangleMesh& mesh) : data_(std::make_unique<Data>()) {
  assert(!mesh.triangles.empty());
  data_->mesh = mesh;
  data_->build_normals();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    if (data_->facet_normals[t].squaredNorm() > 0.0) {
      data_->facets.emplace_back(to_cgal(mesh.vertices[corners[0]]), to_cgal(mesh.vertices[corners[1]]),
                                 to_cgal(mesh.vertices[corners[2]]));
      data_->original.push_back(static_cast<int>(t));
    }
  }
  data_->tree.insert(data_->facets.cbegin(), data_->facets.cend());
  // Built now, so that queries from several threads only read.
  data_->tree.build();
  data_->tree.accelerate_distance_queries();
}

TriangleTree::~TriangleTree() = default;
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;

TriangleTree::Hit TriangleTree::closest(const Vec3& point) const {
  const auto found = data_->tree.closest_point_and_primitive(to_cgal(point));
  Hit hit;
  hit.triangle = data_->original[found.second - data_->facets.cbegin()];
  hit.point = from_cgal(found.first);
  const auto& corners = data_->mesh.triangles[hit.triangle];
  const auto& vertices = data_->mesh.vertices;
  hit.barycentric = barycentric(hit.point, vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]);
  hit.pseudo_normal = data_->pseudo_normal(hit.triangle, hit.barycentric);
  hit.distance = (point - hit.point).norm();
  hit.signed_distance = std::copysign(hit.distance, hit.pseudo_normal.dot(point - hit.point));
  return hit;
}

std::vector<TriangleTree::Hit> TriangleTree::crossings(const Vec3& from, const Vec3& to) const {
  constexpr double beside = 1e-9;  // of a facet
  const Vec3 step = to - from;
  const Vec3 margin = Vec3::Constant(beside * (step.norm() + from.norm()));
  const CGAL::Bbox_3 box = to_cgal(from.cwiseMin(to) - margin).bbox() + to_cgal(from.cwiseMax(to) + margin).bbox();
  std::vector<Iterator> found;
  data_->tree.all_intersected_primitives(Kernel::Iso_cuboid_3(box), std::back_inserter(found));
  std::vector<Hit> hits;
  for (const Iterator& facet : found) {
    Hit hit;
    hit.triangle = data_->original[static_cast<std::size_t>(facet - data_->facets.cbegin())];
    const auto& corners = data_->mesh.triangles[hit.triangle];
    const auto& vertices = data_->mesh.vertices;
    const Vec3& normal = data_->facet_normals[hit.triangle];
    const double along = normal.dot(step);
    if (std::abs(along) < beside * step.norm()) continue;
    const double share = normal.dot(vertices[corners[0]] - from) / along;
    if (share < 0.0 || share > 1.0) continue;
    hit.point = from + share * step;
    hit.barycentric = barycentric(hit.point, vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]);
    if (hit.barycentric.minCoeff() < -beside) continue;
    hit.pseudo_normal = normal;
    hit.distance = share * step.norm();
    hit.signed_distance = std::copysign(hit.distance, -along);
    hits.push_back(hit);
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
  return hits;
}

}  // namespace toile::body
